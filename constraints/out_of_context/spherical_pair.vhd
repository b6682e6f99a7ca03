-- SPDX-License-Identifier: MIT
--
-- spherical_pair: line_interpolator and bell_rom in a row, to be measured out of context: the specular part of paper
-- `spherical`, figure 12, up to its multiplier, with the better base cos^9.5 and three wrap bits.
--
-- Number formats: s(1+w).(phase_bits-1-w) quadrants with w = 3 wrap bits; value u0.8.
-- Latency: that of both units, 4 clocks.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

library sheen;

entity spherical_pair is
  port (
    clk         : in  std_ulogic;
    rst         : in  std_ulogic;
    init        : in  std_ulogic;
    step        : in  std_ulogic;
    sxsb        : in  signed(21 downto 0);  -- s4.18, quadrants
    s           : in  signed(21 downto 0);  -- s4.18, quadrants a pixel
    value_valid : out std_ulogic;
    value       : out unsigned(7 downto 0)  -- u0.8, 255 stands for 1
  );

  attribute latency : integer;
  attribute latency of spherical_pair : entity is 4;
end entity spherical_pair;

architecture rtl of spherical_pair is

  constant address_bits : positive := 8;
  constant wrap_bits    : positive := 3;
  constant ra_bits      : positive := 1 + wrap_bits + address_bits;

  signal ra_valid : std_ulogic;
  signal ra       : signed(ra_bits - 1 downto 0);  -- s4.8, quadrants

begin

  angle : entity sheen.line_interpolator
    generic map (
      phase_bits => s'length,
      ra_bits    => ra_bits
    )
    port map (
      clk      => clk,
      reset    => rst,
      init     => init,
      step     => step,
      sxsb     => sxsb,
      s        => s,
      ra_valid => ra_valid,
      ra       => ra
    );

  bell : entity sheen.bell_rom
    generic map (
      address_bits    => address_bits,
      data_bits       => value'length,
      exponent_tenths => 95,
      wrap_bits       => wrap_bits,
      folded          => true
    )
    port map (
      clk         => clk,
      reset       => rst,
      ra_valid    => ra_valid,
      ra          => ra,
      value_valid => value_valid,
      value       => value
    );

end architecture rtl;
