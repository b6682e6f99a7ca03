-- SPDX-License-Identifier: MIT
--
-- edge_walker: the geometry of a triangle, row by row.
--
-- Walks the long edge in whole pixels. Each row gives one span {x, y, length, direction} and one command to the
-- channels: a step (one row down, kappa pixels along), then, when the long edge's phase accumulator carries, a carry
-- (one pixel more). A row takes 1 + carry clocks. Phases run a row ahead, so that a carry is a registered bit when it is
-- needed; that costs one clock (state prime) per triangle, and one at the middle vertex unless a carry fills it.
--
--              job                       room            long_carry
--     idle ---------> prime --------> row ---- carry? -------> carry
--       ^               ^              | ^                       |
--       |               +- middle -----+ +-----------------------+
--       +---------------- last row ----+
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
    geometry  : in geometry_t;
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

  type walk_t is (idle, prime, row, carry);
  signal walk : walk_t := idle;

  -- What this clock does.
  signal begins        : std_ulogic;
  signal answer        : std_ulogic;
  signal load          : std_ulogic;
  signal in_row        : std_ulogic;
  signal triangle_ends : std_ulogic;
  signal empty_part    : std_ulogic;
  signal reload        : std_ulogic;

  signal below         : std_ulogic;         -- past the middle vertex
  signal none_below    : std_ulogic;         -- the triangle ends at the middle vertex
  signal last_row      : std_ulogic;         -- of this part
  signal first         : std_ulogic;         -- the next span is the triangle's first
  signal first_pending : std_ulogic := '0';  -- the triangle's first span waits in the queue

  signal rows       : coordinate_t;
  signal rows_below : coordinate_t;

  signal long_fresh  : std_ulogic;  -- the long phase was loaded and has given no carry yet
  signal end_fresh   : std_ulogic;  -- the same of the end edge's phase
  signal long_carry  : std_ulogic;
  signal end_carry   : std_ulogic;
  signal long_phase  : phase_t;
  signal long_step   : phase_t;
  signal end_phase   : phase_t;
  signal end_step    : phase_t;
  signal lower_phase : phase_t;
  signal lower_step  : phase_t;

  signal leftward      : std_ulogic;
  signal x             : coordinate_t;
  signal x_step        : coordinate_t;
  signal y             : coordinate_t;
  signal length        : coordinate_t;
  signal length_reload : coordinate_t;
  signal m             : coordinate_t;
  signal m_less_one    : coordinate_t;
  signal m_below       : coordinate_t;

  signal push_row : std_ulogic;

begin

  begins    <= job.valid and not job.message and not first_pending;
  answer    <= job.valid and job.message and room and to_std_ulogic(walk = idle);
  job_taken <= load or answer;

  in_row        <= room and to_std_ulogic(walk = row);
  triangle_ends <= in_row and last_row and (below or none_below);
  empty_part    <= to_std_ulogic(walk = prime and rows = 0);
  reload        <= ((in_row and last_row) or empty_part) and not (below or none_below);

  -- With `first` still set, the last row's span may be the triangle's only one, and its constants are still needed.
  load     <= begins and (to_std_ulogic(walk = idle) or (triangle_ends and not first));
  push_row <= in_row and to_std_ulogic(length /= 0);

  control : process (clk) is
  begin
    if rising_edge(clk) then
      case walk is
        when idle =>
          null;
        when prime =>
          if not empty_part then
            walk <= row;
          elsif not reload then
            walk <= idle;
          end if;
        when row =>
          if triangle_ends then
            walk <= idle;
          elsif in_row and long_carry then
            walk <= carry;
          elsif reload then
            walk <= prime;
          end if;
        when carry =>
          walk <= row;
      end case;
      if load then
        walk <= prime;
      end if;

      last_row <= to_std_ulogic(rows = 2) when in_row else to_std_ulogic(rows = 1);
      if load then
        rows       <= geometry.rows_above;
        rows_below <= geometry.rows_below;
        none_below <= to_std_ulogic(geometry.rows_below = 0);
        below      <= '0';
      elsif reload then
        rows  <= rows_below;
        below <= '1';
      elsif in_row then
        rows <= rows - 1;
      end if;

      first         <= load or (first and not push_row);
      first_pending <= (first_pending or (push_row and first)) and not first_taken;

      if rst then
        walk          <= idle;
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
      elsif in_row = '1' or (walk = prime and long_fresh = '1') then
        long_phase <= sum(phase_bits - 1 downto 0);
        long_carry <= sum(phase_bits);
        long_fresh <= '0';
      end if;

      sum := ('0' & end_phase) + end_step;
      if load then
        end_phase <= geometry.upper_phase;
        end_step  <= geometry.upper_step;
        end_fresh <= '1';
      elsif reload then
        end_phase <= lower_phase;
        end_step  <= lower_step;
        end_fresh <= '1';
      elsif in_row = '1' or walk = prime or (walk = carry and end_fresh = '1') then
        end_phase <= sum(phase_bits - 1 downto 0);
        end_fresh <= '0';
      end if;
      if in_row = '1' or walk = prime or (walk = carry and end_fresh = '1') then
        end_carry <= sum(phase_bits);
      end if;

      if load then
        lower_phase <= geometry.lower_phase;
        lower_step  <= geometry.lower_step;
      end if;
    end if;
  end process phases;

  position : process (clk) is
    variable along  : coordinate_t;
    variable growth : coordinate_t;
  begin
    if rising_edge(clk) then
      if walk /= carry then
        along := x_step;
      elsif leftward then
        along := to_unsigned(2 ** coordinate_bits - 1, coordinate_bits);
      else
        along := to_unsigned(1, coordinate_bits);
      end if;
      growth := m_less_one when long_carry else m;

      m_less_one <= m - 1;
      if load then
        x             <= geometry.x;
        x_step        <= 0 - geometry.kappa when job.leftward else geometry.kappa;
        y             <= geometry.y;
        leftward      <= job.leftward;
        length        <= geometry.length;
        length_reload <= geometry.length_reload;
        m             <= geometry.m;
        m_below       <= geometry.m_below;
      else
        if in_row = '1' or walk = carry then
          x <= x + along;
        end if;
        if in_row then
          y      <= y + 1;
          length <= resize(add_with_carry(length, growth, end_carry), coordinate_bits);
        end if;
        if reload then
          length <= length_reload;
          m      <= m_below;
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
                  step => in_row or to_std_ulogic(walk = carry), carry => to_std_ulogic(walk = carry));
      if answer then
        query         := to_std_ulogic(job.code = "00" and unsigned(job.header(31 downto header_opcode_lsb)) = opcode_query);
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
        span <= (x => x, y => y, length => length, single => to_std_ulogic(length = 1), leftward => leftward, first => first,
                 message => '0');
      end if;
      if rst then
        push         <= '0';
        command.load <= '0';
        command.step <= '0';
      end if;
    end if;
  end process outputs;

end architecture rtl;
