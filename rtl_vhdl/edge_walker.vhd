-- SPDX-License-Identifier: MIT
--
-- edge_walker: the geometry of a triangle, row by row.
--
-- Walks the long edge in whole pixels. Each row gives one span {x, y, length, direction} and one command to the
-- channels: a step (one row down, kappa pixels along), then, when the long edge's phase accumulator carries, a carry
-- (one pixel more). A row takes 1 + carry clocks. Phases run a row ahead, so that a carry is a registered bit when it
-- is needed; that costs one clock (state prime) per triangle, and one at the middle vertex unless a carry fills it.
--
--              job                     long carry
--     idle ---------> prime ------> row ----------> carry
--       ^               ^          | | ^              |
--       |               +- middle -+ | +--------------+
--       +----------------- last row -+
--
-- The edges' phase accumulators are cut in two halves, so that no carry chain is longer than one. The lower half is a
-- step ahead, its carry a register; its first step is made on the way to the accumulator:
--
--   clock        before            load (idle)   prime             first row
--   addend       <= start          <= step
--   lower half                     P + step      + step            + step
--   upper half                     P             + step + carry    + step + carry
--   overflow                                                       of the first row
--
-- While the walker is idle its registers take in whatever stands in geometry, so that none of them waits for the
-- decision to load. An accumulator takes its start from its addend: no multiplexer stands behind an adder. What decides
-- that a register moves is itself a register (long_moves, end_moves, length_moves).
--
-- Rows: u = s*x advances by kappa + carry; L += m + carry_end - carry_long; at the middle vertex L, m and the end
-- edge's phase are reloaded. All fields are modulo 2**12; a row of length 0 gives no span.
--
-- Number formats: coordinates u12.0, phases u0.32. Latency: 1 clock from a decision to span and command.
-- Source: docs/architecture.md, "Coverage"; in place of paper `quadratic`, section 5 (X_start += A_start in real
-- steps), which samples off the pixel centres. Model: hls/include/sheen/hls/edge_walker.hpp.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library sheen;
  use sheen.sheen_constants_pkg.all;
  use sheen.sheen_pkg.all;

entity edge_walker is
  port (
    clk : in std_ulogic;
    rst : in std_ulogic;

    job       : in job_t;
    geometry  : in geometry_t;  -- stable, like job.leftward, from the clock before job.valid to that after job_taken
    job_taken : out std_ulogic;

    room        : in std_ulogic;  -- the span queue takes a span
    first_taken : in std_ulogic;  -- the span walker starts a triangle's first span

    push    : out std_ulogic;
    span    : out span_t;
    command : out edge_command_t
  );

  attribute latency : integer;
  attribute latency of edge_walker : entity is 1;
end entity edge_walker;

architecture rtl of edge_walker is

  -- The state, one bit each.
  signal idle  : std_ulogic := '1';
  signal prime : std_ulogic := '0';
  signal row   : std_ulogic := '0';
  signal carry : std_ulogic := '0';
  signal empty : std_ulogic := '0';  -- no row above the middle vertex: the lower part comes into preset
  signal skip  : std_ulogic := '0';  -- and from there

  signal in_row : std_ulogic := '0';  -- in state row: this clock ends the row (the queue had room a clock ago)

  -- What this clock does.
  signal answer        : std_ulogic;
  signal load          : std_ulogic;
  signal next_row      : std_ulogic;
  signal next_idle     : std_ulogic;
  signal triangle_ends : std_ulogic;
  signal leaves_row    : std_ulogic;
  signal reload        : std_ulogic;
  signal ready         : std_ulogic;  -- for the next triangle: the addends are no longer needed
  signal begins_part   : std_ulogic;  -- the part in preset, if a triangle is there at all
  signal carry_follows : std_ulogic;
  signal push_row      : std_ulogic;

  signal none_above    : std_ulogic;         -- geometry: no row above the middle vertex
  signal none_below    : std_ulogic;
  signal free          : std_ulogic := '0';  -- idle, and the channels' constants are no longer needed
  signal last_part     : std_ulogic;         -- past the middle vertex, or no row below it
  signal middle_row    : std_ulogic;         -- the last row above the middle vertex
  signal final_row     : std_ulogic;         -- the triangle's last row
  signal first         : std_ulogic;         -- the next span is the triangle's first
  signal first_pending : std_ulogic := '0';  -- the triangle's first span waits in the queue

  -- A phase accumulator. While the walker is idle its addend is the edge's start, which it takes over as it stands.
  constant half_bits : positive := phase_bits / 2;
  subtype half_t is unsigned(half_bits - 1 downto 0);
  subtype low_t is unsigned(half_bits downto 0);  -- with the carry of the last step, into the upper half's next

  type edge_t is record
    low         : low_t;
    high        : half_t;
    low_addend  : low_t;
    high_addend : half_t;
    overflow    : std_ulogic;  -- the carry out of the last step: for the row that ends next
  end record edge_t;

  type edge_vector_t is array (natural range <>) of edge_t;
  type phase_vector_t is array (natural range <>) of phase_t;

  -- The edges: the long one, the end edge above the middle vertex and that below it.
  constant long  : natural := 0;
  constant upper : natural := 1;
  constant lower : natural := 2;

  signal edges  : edge_vector_t(0 to 2);
  signal phases : phase_vector_t(0 to 2);
  signal steps  : phase_vector_t(0 to 2);
  signal moves  : std_ulogic_vector(0 to 2);  -- the edge takes over its addend or steps
  signal counts : std_ulogic_vector(0 to 2);  -- the carry is one of a row

  -- One side of the middle vertex.
  type part_t is record
    rows   : coordinate_t;
    length : coordinate_t;
    m      : coordinate_t;
  end record part_t;

  signal part     : part_t;      -- the part being walked
  signal preset   : part_t;      -- the next one: the lower part, then the next triangle's upper part
  signal in_lower : std_ulogic;  -- past the middle vertex

  signal long_moves   : std_ulogic := '1';  -- the long edge is loaded or steps in this clock
  signal end_moves    : std_ulogic := '1';  -- the same of the end edge
  signal length_moves : std_ulogic := '1';  -- the same of the part's length

  signal leftward : std_ulogic;
  signal x        : coordinate_t;  -- inverted when leftward
  signal x_addend : coordinate_t;  -- kappa; while idle, where the triangle starts
  signal y        : coordinate_t;
  signal growth   : coordinate_t;  -- of the length in this clock: m, or -1 in a carry
  signal grown    : unsigned(coordinate_bits + 1 downto 0);

begin

  load      <= free and job.valid and not job.message;
  answer    <= idle and job.valid and job.message and room;
  job_taken <= load or answer;

  triangle_ends <= in_row and final_row;
  reload        <= (in_row and middle_row) or skip;
  begins_part   <= idle or reload;
  ready         <= idle or final_row;
  carry_follows <= in_row and edges(long).overflow and not final_row;
  leaves_row    <= in_row and (edges(long).overflow or middle_row or final_row);
  next_row      <= (row and not leaves_row) or carry or prime;
  next_idle     <= (idle and not (load and not (none_above and none_below))) or triangle_ends;

  push_row <= in_row and to_std_ulogic(part.length /= 0);

  control : process (clk) is
  begin
    if rising_edge(clk) then
      none_above <= to_std_ulogic(geometry.rows_above = 0);
      none_below <= to_std_ulogic(geometry.rows_below = 0);

      idle   <= next_idle;
      free   <= next_idle and not (first_pending or (in_row and first));
      prime  <= (load and not none_above) or skip or (in_row and middle_row and not edges(long).overflow);
      empty  <= load and none_above and not none_below;
      skip   <= empty;
      row    <= next_row;
      in_row <= next_row and room;
      carry  <= carry_follows;

      -- The long edge steps in the first prime and with every row; the end edge once more in the clock after the middle
      -- vertex; the length with every row and every carry but that in the clock after the middle vertex.
      long_moves   <= idle or triangle_ends or (next_row and room);
      end_moves    <= not ((next_row and not room) or (carry_follows and not middle_row));
      length_moves <= not ((next_row and not room) or load or reload);

      if in_row then
        middle_row <= to_std_ulogic(part.rows = 2) and not (idle or last_part);
        final_row  <= to_std_ulogic(part.rows = 2) and last_part and not idle;
      else
        middle_row <= to_std_ulogic(part.rows = 1) and not (idle or last_part);
        final_row  <= to_std_ulogic(part.rows = 1) and last_part and not idle;
      end if;
      in_lower <= (in_lower or reload) and not idle;
      if idle then
        last_part <= none_below;
      elsif reload then
        last_part <= '1';
      end if;

      if begins_part then
        part.rows <= preset.rows;
      elsif in_row then
        part.rows <= part.rows - 1;
      end if;

      first         <= idle or (first and not push_row);
      first_pending <= (first_pending or (push_row and first)) and not first_taken;

      if rst then
        idle          <= '1';
        prime         <= '0';
        empty         <= '0';
        skip          <= '0';
        free          <= '0';
        row           <= '0';
        in_row        <= '0';
        carry         <= '0';
        long_moves    <= '1';
        end_moves     <= '1';
        length_moves  <= '1';
        first_pending <= '0';
      end if;
    end if;
  end process control;

  phases <= (geometry.long_phase, geometry.upper_phase, geometry.lower_phase);
  steps  <= (geometry.long_step, geometry.upper_step, geometry.lower_step);
  moves  <= (long_moves, end_moves, idle or (end_moves and in_lower));
  counts <= (not idle, not in_lower, not idle);

  accumulators : for k in edges'range generate
    signal low   : low_t;
    signal high  : unsigned(half_bits downto 0);
    signal start : low_t;
  begin

    low   <= ('0' & edges(k).low(half_bits - 1 downto 0)) + edges(k).low_addend;
    high  <= add_with_carry(edges(k).high, edges(k).high_addend, edges(k).low(half_bits));
    start <= ('0' & phases(k)(half_bits - 1 downto 0)) + steps(k)(half_bits - 1 downto 0);

    accumulator : process (clk) is
    begin
      if rising_edge(clk) then
        if moves(k) then
          edges(k).low      <= edges(k).low_addend when idle else low;
          edges(k).high     <= edges(k).high_addend when idle else high(half_bits - 1 downto 0);
          edges(k).overflow <= high(half_bits) and counts(k);
        end if;
        if ready then
          edges(k).low_addend  <= '0' & steps(k)(half_bits - 1 downto 0) when load else start;
          edges(k).high_addend <= steps(k)(phase_bits - 1 downto half_bits) when load
                                  else phases(k)(phase_bits - 1 downto half_bits);
        end if;
      end if;
    end process accumulator;

  end generate accumulators;

  -- A triangle begins with the part that waits here, and so does what follows the middle vertex.
  next_part : process (clk) is
  begin
    if rising_edge(clk) then
      if prime or empty then
        preset <= (rows => geometry.rows_below, length => geometry.length_reload, m => geometry.m_below);
      elsif idle or last_part then
        preset <= (rows => geometry.rows_above, length => geometry.length, m => geometry.m);
      end if;
    end if;
  end process next_part;

  -- The carry out of the lowest two bits is that of a row: in_row and one of the overflows.
  grown <= (part.length & in_row & in_row) + (growth & edges(upper).overflow & edges(lower).overflow);

  position : process (clk) is
  begin
    if rising_edge(clk) then
      if idle then
        x        <= x_addend;
        y        <= geometry.y;
        leftward <= job.leftward;
      elsif in_row then
        -- Leftward, not x + kappa + carry = not (x - kappa - carry).
        x <= resize(add_with_carry(x, x_addend, edges(long).overflow), coordinate_bits);
        y <= y + 1;
      end if;
      if ready then
        if load then
          x_addend <= geometry.kappa;
        elsif job.leftward then
          x_addend <= not geometry.x;
        else
          x_addend <= geometry.x;
        end if;
      end if;

      -- Length: m + carry_end with the row, -1 with a carry; a part begins with its own, which has had its carry.
      growth <= part.m;
      if carry_follows then
        growth <= (others => '1');
      end if;
      if begins_part then
        part.m <= preset.m;
      end if;
      if length_moves then
        part.length <= grown(coordinate_bits + 1 downto 2);
        if begins_part then
          part.length <= preset.length;
        end if;
      end if;
    end if;
  end process position;

  outputs : process (clk) is
    variable query : std_ulogic;
  begin
    if rising_edge(clk) then
      push    <= push_row or answer;
      command <= (load => load, linear => job.linear, depth => job.depth,
                  step => in_row or carry, carry => carry);
      if idle then
        query         := to_std_ulogic(job.code = "00"
                                       and unsigned(job.header(31 downto header_opcode_lsb)) = opcode_query);
        span.x        <= unsigned(job.header(coordinate_bits - 1 downto 0));
        span.y        <= unsigned(job.header(2 * coordinate_bits - 1 downto coordinate_bits));
        span.length   <= unsigned(std_ulogic_vector'(job.header(31 downto header_opcode_lsb) & "00" & job.code));
        span.single   <= not query;
        span.leftward <= '0';
        span.first    <= '0';
        span.message  <= '1';
        if query then
          span.length <= to_unsigned(query_reply_words, coordinate_bits);
        end if;
      else
        span <= (x => x, y => y, length => part.length, single => to_std_ulogic(part.length = 1),
                 leftward => leftward, first => first, message => '0');
        if leftward then
          span.x <= not x;
        end if;
      end if;
      if rst then
        push         <= '0';
        command.load <= '0';
        command.step <= '0';
      end if;
    end if;
  end process outputs;

end architecture rtl;
