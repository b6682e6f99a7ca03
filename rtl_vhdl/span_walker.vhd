-- SPDX-License-Identifier: MIT
--
-- span_walker: one pixel position a clock.
--
-- Takes spans from the head of the span queue and steps through them; the next span starts in the clock after the last
-- pixel of the one before. Messages pass in their place, a query as four words whose x counts. The only back-pressure
-- is `go`, a registered bit: it stops this unit, and what has left it flows on into the pixel queue.
--
-- Latency: 1 clock from head to position, 1 more to the fragment. Source: paper `quadratic`, section 5 (inner loop).
-- Model: hls/include/sheen/hls/span_walker.hpp.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library sheen;
  use sheen.sheen_pkg.all;

entity span_walker is
  port (
    clk : in std_ulogic;
    rst : in std_ulogic;

    head_valid : in std_ulogic;
    head       : in span_t;
    head_taken : out std_ulogic;
    go         : in std_ulogic;

    command  : out span_command_t;
    fragment : out fragment_t  -- coordinates u12.0
  );

  attribute latency : integer;
  attribute latency of span_walker : entity is 2;
end entity span_walker;

architecture rtl of span_walker is

  signal active    : std_ulogic := '0';
  signal last      : std_ulogic;
  signal message   : std_ulogic;
  signal query     : std_ulogic;
  signal leftward  : std_ulogic;
  signal x         : coordinate_t;
  signal y         : coordinate_t;
  signal remaining : coordinate_t;  -- words left, this one included; a message's tail
  signal load      : std_ulogic;
  signal steps     : std_ulogic;

begin

  load       <= go and head_valid and (not active or last);
  steps      <= go and active and not last;
  head_taken <= load;

  position : process (clk) is
  begin
    if rising_edge(clk) then
      if load then
        x         <= head.x;
        y         <= head.y;
        remaining <= head.length;
        last      <= head.single;
        leftward  <= head.leftward;
        message   <= head.message;
        query     <= head.message and not head.single;
      elsif steps then
        x         <= x - 1 when leftward else x + 1;
        remaining <= remaining - 1;
        last      <= to_std_ulogic(remaining = 2);
      end if;
      if go then
        active <= load or steps;
      end if;
      if rst then
        active <= '0';
      end if;
    end if;
  end process position;

  outputs : process (clk) is
  begin
    if rising_edge(clk) then
      command  <= (load => load, first => head.first, step => steps);
      fragment <= (valid => go and active, message => message, query => query, log => "00", x => x, y => y,
                   tail => remaining);
      if rst then
        fragment.valid <= '0';
      end if;
    end if;
  end process outputs;

end architecture rtl;
