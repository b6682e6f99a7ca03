-- SPDX-License-Identifier: MIT
--
-- icebreaker_top: a first-order core (flat and gouraud) with depth between the USB serial port and the LEDs of an
-- iCEBreaker, at its 12 MHz clock. 1 Mbaud, 8N1. The green LED blinks, the red one tells that words were lost.

library ieee;
  use ieee.std_logic_1164.all;

library sheen;

entity icebreaker_top is
  generic (
    clocks_per_bit : positive := 12
  );
  port (
    clk_12mhz : in std_ulogic;
    rs232_rx  : in std_ulogic;
    rs232_tx  : out std_ulogic;
    led_red   : out std_ulogic;  -- 0 lights it
    led_green : out std_ulogic   -- 0 lights it
  );
end entity icebreaker_top;

architecture rtl of icebreaker_top is

  signal lost  : std_ulogic;
  signal alive : std_ulogic;

begin

  led_red   <= not lost;
  led_green <= not alive;

  uart : entity sheen.uart_core
    generic map (
      clocks_per_bit => clocks_per_bit,
      words_per_beat => 1,
      has_depth      => true,
      has_quadratic  => false
    )
    port map (
      clk          => clk_12mhz,
      rxd          => rs232_rx,
      txd          => rs232_tx,
      receiving    => open,
      transmitting => open,
      lost         => lost,
      alive        => alive
    );

end architecture rtl;
