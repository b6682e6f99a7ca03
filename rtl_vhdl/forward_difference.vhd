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
-- Commands are seen a clock before they act: the edge part chooses the addends of D and E in the meantime. Its I acts a
-- clock after D and E, whose choice for I is then a register, too, so that nothing stands before or behind an adder.
-- For that a carry comes in the clock after its step, the first step not before the second clock after a load, and a
-- fetch not before the second clock after the push of its entry; walkers and span queue see to all three.
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
    value_bits   : positive := colour_integer_bits;
    family       : string   := "plain"  -- of the accumulators
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
  -- Of slice k: number k + 1; number k comes next, number k + 2 was before and is the edge part's I's.
  signal commands : command_vector_t(0 to slices + 1);

  -- Loads or steps, of both parts.
  signal edge_moves : std_ulogic_vector(0 to slices + 1);
  signal span_moves : std_ulogic_vector(0 to slices + 1);
  signal presents   : std_ulogic_vector(0 to slices);

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
  edge_moves(0)   <= command.edge_part.load or command.edge_part.step;
  span_moves(0)   <= command.span_part.load or command.span_part.step;
  presents(0)     <= present;

  skew : process (clk) is
  begin
    if rising_edge(clk) then
      commands(1 to slices + 1)   <= commands(0 to slices);
      edge_moves(1 to slices + 1) <= edge_moves(0 to slices);
      span_moves(1 to slices + 1) <= span_moves(0 to slices);
      presents(1 to slices)       <= presents(0 to slices - 1);
    end if;
  end process skew;

  slice : for k in 0 to slices - 1 generate
    constant low  : natural := k * slice_width;
    constant high : natural := minimum(width, low + slice_width) - 1;
    constant bits : positive := high - low + 1;
    subtype slice_t is unsigned(bits - 1 downto 0);
    type memory_t is array (0 to 2 ** span_queue_log2 - 1) of slice_t;

    signal next_one : channel_command_t;
    signal now      : channel_command_t;
    signal late     : channel_command_t;
    signal absent   : std_ulogic;
    signal edge_i   : slice_t;
    signal edge_d   : slice_t;
    signal edge_e   : slice_t;
    signal span_i   : slice_t;
    signal span_d   : slice_t;
    signal i_start  : slice_t;  -- the edge part's I's word
    signal i_addend : slice_t;  -- D with a carry, else E
    signal queue_i  : memory_t;
    signal head_i   : slice_t;

    type slice_vector_t is array (natural range <>) of slice_t;
    signal word : slice_vector_t(0 to words'length - 1);
  begin

    next_one <= commands(k);
    now      <= commands(k + 1);
    late     <= commands(k + 2);
    absent   <= not presents(k + 1);

    cut : for n in word'range generate
      word(n) <= unsigned(words(n)(high downto low));
    end generate cut;

    -- Edge part: I, a clock after its slopes.
    i_operands : process (clk) is
    begin
      if rising_edge(clk) then
        i_addend <= edge_d when now.edge_part.carry else edge_e;
        i_start  <= word(0);
        if absent then
          i_start <= (others => '0');
        end if;
      end if;
    end process i_operands;

    edge_start : entity sheen.accumulator
      generic map (
        width  => bits,
        family => family
      )
      port map (
        clk       => clk,
        enable    => edge_moves(k + 2),
        load      => late.edge_part.load,
        start     => i_start,
        addend    => i_addend,
        carry_in  => edge_i_carry(k),
        value     => edge_i,
        carry_out => edge_i_carry(k + 1)
      );

    -- I's share of the span queue.
    starts : process (clk) is
    begin
      if rising_edge(clk) then
        if late.push then
          queue_i(to_integer(late.push_address)) <= edge_i;
        end if;
        if now.fetch then
          head_i <= queue_i(to_integer(now.fetch_address));
        end if;
      end if;
    end process starts;

    -- Span part: I.
    span_start : entity sheen.accumulator
      generic map (
        width  => bits,
        family => family
      )
      port map (
        clk       => clk,
        enable    => span_moves(k + 1),
        load      => now.span_part.load,
        start     => head_i,
        addend    => span_d,
        carry_in  => span_i_carry(k),
        value     => span_i,
        carry_out => span_i_carry(k + 1)
      );

    -- The slopes: second-order ones are accumulators of their own, linear ones are constants of the triangle.
    curved : if second_order generate
      signal edge_h   : slice_t;
      signal edge_dd  : slice_t;
      signal edge_de  : slice_t;
      signal span_h   : slice_t;
      signal d_start  : slice_t;
      signal e_start  : slice_t;
      signal d_addend : slice_t;  -- h with a carry, else dD
      signal e_addend : slice_t;  -- dD with a carry, else dE
      signal queue_d  : memory_t;
      signal head_d   : slice_t;
    begin

      d_start <= word(1) when not absent else (others => '0');
      e_start <= word(2) when not absent else (others => '0');

      second_differences : process (clk) is
      begin
        if rising_edge(clk) then
          d_addend <= edge_h when next_one.edge_part.carry else edge_dd;
          e_addend <= edge_dd when next_one.edge_part.carry else edge_de;
          if now.edge_part.load then
            edge_h  <= word(3);
            edge_dd <= word(4);
            edge_de <= word(5);
            if now.edge_part.linear or absent then
              edge_h  <= (others => '0');
              edge_dd <= (others => '0');
              edge_de <= (others => '0');
            end if;
          end if;
          if now.span_part.load and now.span_part.first then
            span_h <= edge_h;
          end if;
        end if;
      end process second_differences;

      edge_slope : entity sheen.accumulator
        generic map (
          width  => bits,
          family => family
        )
        port map (
          clk       => clk,
          enable    => edge_moves(k + 1),
          load      => now.edge_part.load,
          start     => d_start,
          addend    => d_addend,
          carry_in  => edge_d_carry(k),
          value     => edge_d,
          carry_out => edge_d_carry(k + 1)
        );

      row_slope : entity sheen.accumulator
        generic map (
          width  => bits,
          family => family
        )
        port map (
          clk       => clk,
          enable    => edge_moves(k + 1),
          load      => now.edge_part.load,
          start     => e_start,
          addend    => e_addend,
          carry_in  => edge_e_carry(k),
          value     => edge_e,
          carry_out => edge_e_carry(k + 1)
        );

      -- D's share of the span queue.
      slopes : process (clk) is
      begin
        if rising_edge(clk) then
          if now.push then
            queue_d(to_integer(now.push_address)) <= edge_d;
          end if;
          if now.fetch then
            head_d <= queue_d(to_integer(now.fetch_address));
          end if;
        end if;
      end process slopes;

      span_slope : entity sheen.accumulator
        generic map (
          width  => bits,
          family => family
        )
        port map (
          clk       => clk,
          enable    => span_moves(k + 1),
          load      => now.span_part.load,
          start     => head_d,
          addend    => span_h,
          carry_in  => span_d_carry(k),
          value     => span_d,
          carry_out => span_d_carry(k + 1)
        );

    else generate

      constant_slopes : process (clk) is
      begin
        if rising_edge(clk) then
          if now.edge_part.load then
            edge_d <= word(1);
            edge_e <= word(2);
            if absent then
              edge_d <= (others => '0');
              edge_e <= (others => '0');
            end if;
          end if;
          if now.span_part.load and now.span_part.first then
            span_d <= edge_d;
          end if;
        end if;
      end process constant_slopes;

    end generate curved;

    visible : if k = slices - 1 generate
      value <= std_ulogic_vector(span_i(bits - 1 downto bits - value_bits));
    end generate visible;

  end generate slice;

end architecture rtl;
