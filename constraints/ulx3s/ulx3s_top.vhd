-- SPDX-License-Identifier: MIT
--
-- ulx3s_top: the default core between the USB serial port and the LEDs of a ULX3S, at its 25 MHz oscillator's clock.
-- 1 Mbaud, 8N1. LEDs: 0 blinks, 1 receiving, 2 transmitting, 3 words were lost.

library ieee;
  use ieee.std_logic_1164.all;

library sheen;

entity ulx3s_top is
  generic (
    clocks_per_bit : positive := 25
  );
  port (
    clk_25mhz  : in std_ulogic;
    ftdi_txd   : in std_ulogic;                      -- the FTDI chip sends, the FPGA receives
    ftdi_rxd   : out std_ulogic;                     -- the FPGA sends
    wifi_gpio0 : out std_ulogic;                     -- 1 keeps the ESP32 from taking the FPGA over
    led        : out std_ulogic_vector(7 downto 0)
  );
end entity ulx3s_top;

architecture rtl of ulx3s_top is

begin

  wifi_gpio0      <= '1';
  led(7 downto 4) <= "0000";

  uart : entity sheen.uart_core
    generic map (
      clocks_per_bit => clocks_per_bit,
      words_per_beat => 2,
      has_depth      => true,
      has_quadratic  => true
    )
    port map (
      clk          => clk_25mhz,
      rxd          => ftdi_txd,
      txd          => ftdi_rxd,
      receiving    => led(1),
      transmitting => led(2),
      lost         => led(3),
      alive        => led(0)
    );

end architecture rtl;
