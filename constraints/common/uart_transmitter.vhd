-- SPDX-License-Identifier: MIT
--
-- uart_transmitter: bytes onto a serial line, 8N1, lowest bit first.
--
-- A byte is taken when byte_valid and byte_ready meet; the line then carries a start bit 0, the byte, a stop bit 1,
-- each for clocks_per_bit clocks. Bytes that wait follow with one clock more of stop bit.

library ieee;
  use ieee.std_logic_1164.all;

entity uart_transmitter is
  generic (
    clocks_per_bit : positive
  );
  port (
    clk : in std_ulogic;
    rst : in std_ulogic;

    byte_valid : in std_ulogic;
    byte_ready : out std_ulogic;
    octet       : in std_ulogic_vector(7 downto 0);

    txd : out std_ulogic
  );
end entity uart_transmitter;

architecture rtl of uart_transmitter is

  constant frame_bits : positive := 10;

  signal active    : std_ulogic := '0';
  signal bits_left : natural range 0 to frame_bits - 1;
  signal clock     : natural range 0 to clocks_per_bit - 1;
  signal shift     : std_ulogic_vector(frame_bits - 2 downto 0);
  signal line_out  : std_ulogic := '1';

begin

  byte_ready <= not active;
  txd        <= line_out;

  transmit : process (clk) is
  begin
    if rising_edge(clk) then
      if not active then
        if byte_valid then
          active    <= '1';
          line_out  <= '0';
          shift     <= '1' & octet;
          bits_left <= frame_bits - 1;
          clock     <= clocks_per_bit - 1;
        end if;
      elsif clock /= 0 then
        clock <= clock - 1;
      elsif bits_left = 0 then
        active <= '0';
      else
        clock     <= clocks_per_bit - 1;
        bits_left <= bits_left - 1;
        line_out  <= shift(0);
        shift     <= '1' & shift(shift'left downto 1);
      end if;

      if rst then
        active   <= '0';
        line_out <= '1';
      end if;
    end if;
  end process transmit;

end architecture rtl;
