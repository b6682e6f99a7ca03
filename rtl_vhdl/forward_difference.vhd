-- SPDX-License-Identifier: MIT
--
-- forward_difference: one channel of the datapath, start edge and span, by additions only.
--
-- A channel is six words {I, D, E, h, dD, dE}. Its value on row j, u pixels along the stepping direction, is
--
--   V(u, j) = I + u D + j E + C(u,2) h + u j dD + C(j,2) dE   (mod 2**width)
--
-- exactly, for any six words: integer additions carry no rounding.
--
--   edge part   step   I += E, E += dE, D += dD        span part   step   I += D, D += h
--               carry  I += D, D += h,  E += dD                    load   {I, D} from the span queue
--
-- Between the two stands the channel's share of the span queue, which holds {I, D} of the rows that the edge walker is
-- ahead. h (and the D of a linear channel, which is constant) is taken over with a triangle's first span.
--
-- Skew: the words are cut into `slices`; slice k does everything k clocks after slice 0 and gets its carries through
-- registers, so that no carry chain is longer than a slice. All accumulators have the same skew, so chained ones need
-- no delays between them, and only the upper slice is visible outside:
--
--   clock      t                t+1
--   slice 0    I(15..0)  + c -> carry register
--   slice 1                     I(31..16) + carry
--
-- Commands are seen a clock before they act: the edge part chooses its addends in the meantime, so that nothing stands
-- before an adder, and one multiplexer behind it. For that a carry comes in the clock after its step, and the first
-- step not before the second clock after a load; the edge walker sees to both.
--
-- Number format: the channel's, the same for all six words (colour s10.22, depth u16.16; narrower channels take the
-- low `width` bits of each word). Latency: 2 clocks from a command to slice 0, one more for each
-- further slice.
-- Source: paper `quadratic`, section 5 and figure 6; the carry step replaces the paper's real steps of X_start.
-- Model: hls/include/sheen/hls/forward_difference.hpp.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library sheen;
  use sheen.sheen_constants_pkg.all;
  use sheen.sheen_pkg.all;

entity forward_difference is
  generic (
    width        : positive := word_bits;
    slices       : positive := 2;
    second_order : boolean  := true;
    value_bits   : positive := colour_integer_bits
  );
  port (
    clk     : in std_ulogic;
    command : in channel_command_t;
    -- With load: the packet has the channel; else its value is 0.
    present : in std_ulogic;
    -- I, D, E and, with second_order, h, dD, dE.
    words   : in word_vector_t(0 to choose(second_order, quadratic_words, linear_words) - 1);
    -- The upper bits of the span part's I.
    value   : out std_ulogic_vector(value_bits - 1 downto 0)
  );

  attribute latency : integer;
  attribute latency of forward_difference : entity is 2;  -- of slice 0; each further slice adds one
end entity forward_difference;

architecture rtl of forward_difference is

  constant slice_width : positive := (width + slices - 1) / slices;

  type command_vector_t is array (natural range <>) of channel_command_t;
  signal commands : command_vector_t(0 to slices);     -- of slice k: number k + 1; number k is what comes next
  signal presents : std_ulogic_vector(0 to slices);

  -- Carries into slice k; into slice 0 there is none.
  subtype carries_t is std_ulogic_vector(0 to slices);
  signal edge_i_carry : carries_t;
  signal edge_d_carry : carries_t;
  signal edge_e_carry : carries_t;
  signal span_i_carry : carries_t;
  signal span_d_carry : carries_t;

begin

  assert slices <= width
    report "forward_difference: slices is " & integer'image(slices) & ", it must not exceed the width, "
           & integer'image(width)
    severity failure;
  assert value_bits <= width - (slices - 1) * slice_width
    report "forward_difference: value_bits is " & integer'image(value_bits) & ", the upper slice has "
           & integer'image(width - (slices - 1) * slice_width)
    severity failure;

  edge_i_carry(0) <= '0';
  edge_d_carry(0) <= '0';
  edge_e_carry(0) <= '0';
  span_i_carry(0) <= '0';
  span_d_carry(0) <= '0';
  commands(0)     <= command;
  presents(0)     <= present;

  skew : for k in 1 to slices generate
    commands(k) <= commands(k - 1) when rising_edge(clk);
    presents(k) <= presents(k - 1) when rising_edge(clk);
  end generate skew;

  slice : for k in 0 to slices - 1 generate
    constant low  : natural := k * slice_width;
    constant high : natural := minimum(width, low + slice_width) - 1;
    constant bits : positive := high - low + 1;
    subtype slice_t is unsigned(bits - 1 downto 0);

    signal c           : channel_command_t;
    signal present_now : std_ulogic;
    signal carry_next  : std_ulogic;  -- the next clock's step is a carry
    signal edge_i      : slice_t;
    signal edge_d      : slice_t;
    signal edge_e      : slice_t;
    signal edge_h      : slice_t;
    signal span_i      : slice_t;
    signal span_d      : slice_t;
    signal i_addend    : slice_t;     -- D before a carry, else E
    signal i_sum       : unsigned(bits downto 0);
    signal next_i      : unsigned(bits downto 0);
    signal head_i      : slice_t;

    type slice_vector_t is array (natural range <>) of slice_t;
    signal word : slice_vector_t(0 to words'length - 1);
  begin

    c           <= commands(k + 1);
    present_now <= presents(k + 1);
    carry_next  <= commands(k).edge_part.carry;

    cut : for n in word'range generate
      word(n) <= unsigned(words(n)(high downto low));
    end generate cut;

    -- Edge part: I.
    i_sum <= add_with_carry(edge_i, i_addend, edge_i_carry(k));

    edge_start : process (clk) is
    begin
      if rising_edge(clk) then
        if c.edge_part.load then
          edge_i <= word(0);
          if not present_now then
            edge_i <= (others => '0');
          end if;
        elsif c.edge_part.step then
          edge_i              <= i_sum(bits - 1 downto 0);
          edge_i_carry(k + 1) <= i_sum(bits);
        end if;
      end if;
    end process edge_start;

    -- Span part: I.
    next_i <= add_with_carry(span_i, span_d, span_i_carry(k));

    span_start : process (clk) is
    begin
      if rising_edge(clk) then
        if c.span_part.load then
          span_i <= head_i;
        elsif c.span_part.step then
          span_i              <= next_i(bits - 1 downto 0);
          span_i_carry(k + 1) <= next_i(bits);
        end if;
      end if;
    end process span_start;

    -- The slopes: second-order ones are accumulators of their own, linear ones are constants of the triangle.
    curved : if second_order generate
      signal edge_dd  : slice_t;
      signal edge_de  : slice_t;
      signal span_h   : slice_t;
      signal head_d   : slice_t;
      signal loaded   : std_ulogic := '0';
      signal d_addend : slice_t;
      signal e_addend : slice_t;
      signal d_sum    : unsigned(bits downto 0);
      signal e_sum    : unsigned(bits downto 0);
      signal next_d   : unsigned(bits downto 0);

      type memory_t is array (0 to 2 ** span_queue_log2 - 1) of std_ulogic_vector(2 * bits - 1 downto 0);
      signal memory : memory_t;
      signal head   : std_ulogic_vector(2 * bits - 1 downto 0);
    begin

      d_sum <= add_with_carry(edge_d, d_addend, edge_d_carry(k));
      e_sum <= add_with_carry(edge_e, e_addend, edge_e_carry(k));

      -- In the clock after a load E + 0 goes to I's addend, so that no word needs a way to it.
      addends : process (clk) is
      begin
        if rising_edge(clk) then
          loaded   <= c.edge_part.load;
          d_addend <= edge_h when carry_next else edge_dd;
          e_addend <= edge_dd when carry_next else edge_de;
          if c.edge_part.load then
            e_addend <= (others => '0');
          end if;
          if c.edge_part.step or loaded then
            i_addend <= d_sum(bits - 1 downto 0) when carry_next else e_sum(bits - 1 downto 0);
          end if;
        end if;
      end process addends;

      edge_slopes : process (clk) is
      begin
        if rising_edge(clk) then
          if c.edge_part.load then
            edge_d  <= word(1);
            edge_e  <= word(2);
            edge_h  <= word(3);
            edge_dd <= word(4);
            edge_de <= word(5);

            edge_e_carry(k + 1) <= '0';
            if c.edge_part.linear or not present_now then
              edge_h  <= (others => '0');
              edge_dd <= (others => '0');
              edge_de <= (others => '0');
            end if;
            if not present_now then
              edge_d <= (others => '0');
              edge_e <= (others => '0');
            end if;
          elsif c.edge_part.step then
            edge_d              <= d_sum(bits - 1 downto 0);
            edge_d_carry(k + 1) <= d_sum(bits);
            edge_e              <= e_sum(bits - 1 downto 0);
            edge_e_carry(k + 1) <= e_sum(bits);
          end if;
        end if;
      end process edge_slopes;

      next_d <= add_with_carry(span_d, span_h, span_d_carry(k));

      span_slope : process (clk) is
      begin
        if rising_edge(clk) then
          if c.span_part.load then
            span_d <= head_d;
            if c.span_part.first then
              span_h <= edge_h;
            end if;
          elsif c.span_part.step then
            span_d              <= next_d(bits - 1 downto 0);
            span_d_carry(k + 1) <= next_d(bits);
          end if;
        end if;
      end process span_slope;

      queue : process (clk) is
      begin
        if rising_edge(clk) then
          if c.push then
            memory(to_integer(c.push_address)) <= std_ulogic_vector(edge_d) & std_ulogic_vector(edge_i);
          end if;
          if c.fetch then
            head <= memory(to_integer(c.fetch_address));
          end if;
        end if;
      end process queue;

      head_i <= unsigned(head(bits - 1 downto 0));
      head_d <= unsigned(head(2 * bits - 1 downto bits));

    else generate
      type memory_t is array (0 to 2 ** span_queue_log2 - 1) of std_ulogic_vector(bits - 1 downto 0);
      signal memory : memory_t;
    begin

      addend : process (clk) is
      begin
        if rising_edge(clk) then
          i_addend <= edge_d when carry_next else edge_e;
        end if;
      end process addend;

      edge_slopes : process (clk) is
      begin
        if rising_edge(clk) then
          if c.edge_part.load then
            edge_d <= word(1);
            edge_e <= word(2);
            if not present_now then
              edge_d <= (others => '0');
              edge_e <= (others => '0');
            end if;
          end if;
        end if;
      end process edge_slopes;

      span_slope : process (clk) is
      begin
        if rising_edge(clk) then
          if c.span_part.load and c.span_part.first then
            span_d <= edge_d;
          end if;
        end if;
      end process span_slope;

      queue : process (clk) is
      begin
        if rising_edge(clk) then
          if c.push then
            memory(to_integer(c.push_address)) <= std_ulogic_vector(edge_i);
          end if;
          if c.fetch then
            head_i <= unsigned(memory(to_integer(c.fetch_address)));
          end if;
        end if;
      end process queue;

    end generate curved;

    visible : if k = slices - 1 generate
      value <= std_ulogic_vector(span_i(bits - 1 downto bits - value_bits));
    end generate visible;

  end generate slice;

end architecture rtl;
