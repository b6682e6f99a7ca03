-- SPDX-License-Identifier: MIT
--
-- hx8k_breakout_top: a core with a 32-bit setup stream, second order and depth, between the USB serial port and the
-- LEDs of an iCE40-HX8K breakout board, at its 12 MHz clock. 1 Mbaud, 8N1. LEDs: 0 (D9) blinks, 1 receiving,
-- 2 transmitting, 3 words were lost.

library ieee;
  use ieee.std_logic_1164.all;

library sheen;

entity hx8k_breakout_top is
  generic (
    clocks_per_bit : positive := 12
  );
  port (
    clk_12mhz : in std_ulogic;
    rs232_rx  : in std_ulogic;
    rs232_tx  : out std_ulogic;
    led       : out std_ulogic_vector(7 downto 0)
  );
end entity hx8k_breakout_top;

architecture rtl of hx8k_breakout_top is

begin

  led(7 downto 4) <= "0000";

  uart : entity sheen.uart_core
    generic map (
      clocks_per_bit => clocks_per_bit,
      words_per_beat => 1,
      has_depth      => true,
      has_quadratic  => true
    )
    port map (
      clk          => clk_12mhz,
      rxd          => rs232_rx,
      txd          => rs232_tx,
      receiving    => led(1),
      transmitting => led(2),
      lost         => led(3),
      alive        => led(0)
    );

end architecture rtl;
