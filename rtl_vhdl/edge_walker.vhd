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
    geometry  : in geometry_t;  -- stable from the clock before job.valid until the job is taken
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
  signal skip  : std_ulogic := '0';

  signal in_row : std_ulogic := '0';  -- in state row: this clock ends the row (the queue had room a clock ago)

  -- What this clock does.
  signal answer        : std_ulogic;
  signal load          : std_ulogic;
  signal next_row      : std_ulogic;
  signal next_idle     : std_ulogic;
  signal triangle_ends : std_ulogic;
  signal no_rows       : std_ulogic;
  signal reload        : std_ulogic;
  signal carry_follows : std_ulogic;

  signal free          : std_ulogic := '0';  -- idle, and the channels' constants are no longer needed
  signal starts_below  : std_ulogic;         -- no row above the middle vertex, but some below it
  signal last_part     : std_ulogic;         -- past the middle vertex, or no row below it
  signal middle_row    : std_ulogic;         -- the last row above the middle vertex
  signal final_row     : std_ulogic;         -- the triangle's last row
  signal first         : std_ulogic;         -- the next span is the triangle's first
  signal first_pending : std_ulogic := '0';  -- the triangle's first span waits in the queue

  -- One side of the middle vertex.
  type part_t is record
    rows      : coordinate_t;
    length    : coordinate_t;
    m         : coordinate_t;
    end_phase : phase_t;
    end_step  : phase_t;
  end record part_t;

  signal part   : part_t;      -- the part being walked
  signal preset : part_t;      -- the next one: the lower part, then the next triangle's upper part

  signal begins_part : std_ulogic;

  signal long_fresh  : std_ulogic;  -- the long phase was loaded and has given no carry yet
  signal end_fresh   : std_ulogic;  -- the same of the end edge's phase
  signal long_carry  : std_ulogic;
  signal x_carry     : std_ulogic;  -- long_carry, inverted when leftward
  signal end_carry   : std_ulogic;
  signal long_phase  : phase_t;
  signal long_step   : phase_t;

  signal leftward      : std_ulogic;
  signal x             : coordinate_t;
  signal x_step        : coordinate_t;  -- kappa, inverted when leftward
  signal y             : coordinate_t;
  signal growth        : coordinate_t;  -- of the length in this clock: m, or -1 in a carry

  signal push_row : std_ulogic;

begin

  load      <= free and job.valid and not job.message;
  answer    <= idle and job.valid and job.message and room;
  job_taken <= load or answer;
  no_rows   <= to_std_ulogic(geometry.rows_above = 0 and geometry.rows_below = 0);

  triangle_ends <= in_row and final_row;
  reload        <= (in_row and middle_row) or skip;
  begins_part   <= load or reload;
  carry_follows <= in_row and long_carry and not final_row;
  next_row      <= (row and not in_row) or (in_row and not (long_carry or middle_row or final_row)) or carry
                   or (prime and not starts_below);
  next_idle     <= (idle and not (load and not no_rows)) or triangle_ends;

  push_row <= in_row and to_std_ulogic(part.length /= 0);

  control : process (clk) is
  begin
    if rising_edge(clk) then
      idle   <= next_idle;
      free   <= next_idle and not (first_pending or (in_row and first));
      prime  <= (load and not no_rows) or skip or (in_row and middle_row and not long_carry);
      skip   <= prime and starts_below;
      row    <= next_row;
      in_row <= next_row and room;
      carry  <= carry_follows;

      if in_row then
        middle_row <= to_std_ulogic(part.rows = 2) and not last_part;
        final_row  <= to_std_ulogic(part.rows = 2) and last_part;
      else
        middle_row <= to_std_ulogic(part.rows = 1) and not last_part;
        final_row  <= to_std_ulogic(part.rows = 1) and last_part;
      end if;
      if load then
        starts_below <= to_std_ulogic(geometry.rows_above = 0);
        last_part    <= to_std_ulogic(geometry.rows_below = 0);
      elsif reload then
        starts_below <= '0';
        last_part    <= '1';
      end if;

      if begins_part then
        part.rows <= preset.rows;
      elsif in_row then
        part.rows <= part.rows - 1;
      end if;

      first         <= load or (first and not push_row);
      first_pending <= (first_pending or (push_row and first)) and not first_taken;

      if rst then
        idle          <= '1';
        prime         <= '0';
        skip          <= '0';
        free          <= '0';
        row           <= '0';
        in_row        <= '0';
        carry         <= '0';
        first_pending <= '0';
      end if;
    end if;
  end process control;

  phases : process (clk) is
    variable sum : unsigned(phase_bits downto 0);
  begin
    if rising_edge(clk) then
      -- The long edge steps with every row, the end edge too but for the row that reloads it.
      sum := ('0' & long_phase) + long_step;
      if load then
        long_phase <= geometry.long_phase;
        long_step  <= geometry.long_step;
        long_fresh <= '1';
      elsif in_row or (prime and long_fresh) then
        long_phase <= sum(phase_bits - 1 downto 0);
        long_carry <= sum(phase_bits);
        x_carry    <= sum(phase_bits) xor leftward;
        long_fresh <= '0';
      end if;

      sum := ('0' & part.end_phase) + part.end_step;
      if begins_part then
        part.end_phase <= preset.end_phase;
        part.end_step  <= preset.end_step;
        end_fresh      <= '1';
      elsif in_row or prime or (carry and end_fresh) then
        part.end_phase <= sum(phase_bits - 1 downto 0);
        end_fresh      <= '0';
      end if;
      if in_row or prime or (carry and end_fresh) then
        end_carry <= sum(phase_bits);
      end if;
    end if;
  end process phases;

  -- A triangle begins with the part that waits here, and so does what follows the middle vertex.
  next_part : process (clk) is
  begin
    if rising_edge(clk) then
      if load then
        preset <= (rows => geometry.rows_below, length => geometry.length_reload, m => geometry.m_below,
                   end_phase => geometry.lower_phase, end_step => geometry.lower_step);
      elsif idle or last_part then
        preset <= (rows => geometry.rows_above, length => geometry.length, m => geometry.m,
                   end_phase => geometry.upper_phase, end_step => geometry.upper_step);
      end if;
    end if;
  end process next_part;

  position : process (clk) is
  begin
    if rising_edge(clk) then
      if load then
        x        <= geometry.x;
        x_step   <= not geometry.kappa when job.leftward else geometry.kappa;
        y        <= geometry.y;
        leftward <= job.leftward;
      elsif in_row then
        -- s * (kappa + carry): leftward -kappa - carry = not kappa + not carry.
        x <= resize(add_with_carry(x, x_step, x_carry), coordinate_bits);
        y <= y + 1;
      end if;

      -- Length: m + carry_end with the row, -1 with a carry; a part begins with its own, which has had its carry.
      growth <= part.m;
      if carry_follows then
        growth <= (others => '1');
      end if;
      if begins_part then
        part.length <= preset.length;
        part.m      <= preset.m;
      elsif in_row or (carry and not end_fresh) then
        part.length <= resize(add_with_carry(part.length, growth, end_carry and in_row), coordinate_bits);
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
      if answer then
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
      end if;
      if rst then
        push         <= '0';
        command.load <= '0';
        command.step <= '0';
      end if;
    end if;
  end process outputs;

end architecture rtl;
