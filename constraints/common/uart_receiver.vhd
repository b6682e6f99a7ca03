-- SPDX-License-Identifier: MIT
--
-- uart_receiver: bytes from a serial line, 8N1, lowest bit first.
--
--   rxd   ---------+     +-----+-----+-   -+-----+---------
--          idle    |start|  0  |  1  | ... |  7  |  stop
--                  +-----+-----+-----+-   -+-----+
--   counter        |  ^ half a bit, then every bit: samples in the middle
--
-- A stop bit that is 0 gives no byte but `fault`: noise, another rate, or a line break, which a host sends on purpose.
-- The receiver then waits for an idle line.
--
-- `rxd` is asynchronous and passes two registers. At clocks_per_bit >= 8 sender and receiver may differ by 2 % in rate.

library ieee;
  use ieee.std_logic_1164.all;

entity uart_receiver is
  generic (
    clocks_per_bit : positive
  );
  port (
    clk : in std_ulogic;
    rst : in std_ulogic;

    rxd : in std_ulogic;

    byte_valid : out std_ulogic;                     -- for one clock
    octet       : out std_ulogic_vector(7 downto 0);
    fault      : out std_ulogic                      -- for one clock
  );
end entity uart_receiver;

architecture rtl of uart_receiver is

  constant last_bit : positive := 9;  -- bit 0 is the start bit, 9 the stop bit

  signal line_early : std_ulogic := '1';
  signal line_now   : std_ulogic := '1';
  signal active     : std_ulogic := '0';
  signal idle_seen  : std_ulogic := '0';
  signal bit_number : natural range 0 to last_bit;
  signal clock      : natural range 0 to clocks_per_bit - 1;
  signal shift      : std_ulogic_vector(7 downto 0);

begin

  assert clocks_per_bit >= 4
    report "uart_receiver: clocks_per_bit is " & integer'image(clocks_per_bit) & ", it must be at least 4"
    severity failure;

  octet <= shift;

  receive : process (clk) is
  begin
    if rising_edge(clk) then
      line_early <= rxd;
      line_now   <= line_early;
      byte_valid <= '0';
      fault      <= '0';

      if not active then
        idle_seen  <= idle_seen or line_now;
        bit_number <= 0;
        clock      <= clocks_per_bit / 2 - 1;
        active     <= idle_seen and not line_now;
      elsif clock /= 0 then
        clock <= clock - 1;
      else
        clock <= clocks_per_bit - 1;
        if bit_number = last_bit then
          active     <= '0';
          idle_seen  <= line_now;
          byte_valid <= line_now;
          fault      <= not line_now;
        else
          bit_number <= bit_number + 1;
          if bit_number = 0 then
            active <= not line_now;  -- a glitch is no start bit
          else
            shift <= line_now & shift(7 downto 1);
          end if;
        end if;
      end if;

      if rst then
        active     <= '0';
        idle_seen  <= '0';
        byte_valid <= '0';
        fault      <= '0';
      end if;
    end if;
  end process receive;

end architecture rtl;
