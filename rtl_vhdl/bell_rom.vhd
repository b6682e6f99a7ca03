-- SPDX-License-Identifier: MIT
--
-- bell_rom: cos^p of an angle by one table read (paper `spherical`, section 4, the ROMs of figure 12).
--
--   value = cos^p(xi) for |xi| < pi/2, 0 outside     (eq. 19; p = exponent_tenths / 10)
--
-- The bins of the table lie symmetrically about 0 and an entry is the value at its bin's centre, rounded to nearest.
-- cos is even, so a negative angle's bin is the complement of a positive one's, value(not ra) = value(ra), and a
-- quadrant can serve both signs. ra is cut like this, q being the bits of a quadrant's bins:
--
--       ra          | s | w ... w | q ... q |
--       outside     |<- not all equal ->|           |xi| >= pi/2: the value is 0
--       address     | s |         | q ... q |       folded = false: the table holds both halves; no logic before it
--                                 | q xor s |       folded = true: the table holds one quadrant
--
-- Folding halves the memory and never changes a value. The paper addresses its 6x6 ROM by the six top bits of the
-- angle register alone: address_bits = 6, data_bits = 6, wrap_bits = 0, folded = false. With no wrap bits the angle
-- comes round again past pi/2, so whoever makes it must keep it inside, or the highlight shows a ghost; 3 to 5 wrap
-- bits let it run over 8 to 32 quadrants either way.
--
-- Error of value against cos^p(xi), in units of its last place: at most 1/2 from rounding and, at the steepest slope
-- sqrt(p)*((p-1)/p)**((p-1)/2), half a bin: (2**data_bits - 1)*(pi/4)/2**q. The generated package states both the bound
-- and the measured error of each table.
--
-- Three stages, one read a clock: address register, data register (both plain, so that block RAM can take them in),
-- output register with the zero outside. The data path is not reset; only the valid bits are.
-- Kernel: hls/include/sheen/hls/bell_rom.hpp, equal to the bit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.bell_rom_pkg.all;

entity bell_rom is
  generic (
    -- The ROM has 2**address_bits words of data_bits bits.
    address_bits : positive := 6;
    data_bits    : positive := 6;
    -- Ten times the exponent p of the base cos^p: 10 for cos, 20 for cos^2, 95 for cos^9.5.
    exponent_tenths : positive := 20;
    -- Bits of ra between its sign and the quadrant's bins.
    wrap_bits : natural := 0;
    -- The ROM holds one quadrant instead of both halves.
    folded : boolean := false
  );
  port (
    clk         : in  std_ulogic;
    reset       : in  std_ulogic;
    ra_valid    : in  std_ulogic;
    -- s(1+wrap_bits).q, quadrants; q is address_bits if folded, else address_bits - 1
    ra          : in  signed(wrap_bits + address_bits + boolean'pos(folded) - 1 downto 0);
    value_valid : out std_ulogic;
    value       : out unsigned(data_bits - 1 downto 0) -- u0.data_bits, 2**data_bits - 1 stands for 1
  );

  -- value follows ra by this many clocks.
  attribute latency : positive;
  attribute latency of bell_rom : entity is 3;
end entity;

architecture rtl of bell_rom is

  constant quadrant_bits : natural := address_bits - boolean'pos(not folded);

  subtype address_t is unsigned(address_bits - 1 downto 0);
  subtype value_t is unsigned(data_bits - 1 downto 0);

  type rom_t is array (0 to 2 ** address_bits - 1) of value_t;

  -- One quadrant as it is, or both halves in the order of a two's complement address.
  function rom_contents return rom_t is
    constant quadrant : bell_table_t(0 to 2 ** quadrant_bits - 1) :=
      bell_table(quadrant_bits, data_bits, exponent_tenths);
    variable contents : rom_t;
  begin
    for bin in quadrant'range loop
      contents(bin) := to_unsigned(quadrant(bin), data_bits);
      if not folded then
        contents(rom_t'high - bin) := to_unsigned(quadrant(bin), data_bits);
      end if;
    end loop;
    return contents;
  end function;

  constant rom : rom_t := rom_contents;

  function is_outside(angle : signed) return std_ulogic is
    variable top : signed(wrap_bits downto 0);
  begin
    top := angle(angle'high downto angle'high - wrap_bits);
    return (or top) and not (and top);
  end function;

  function address_of(angle : signed) return address_t is
    variable bin  : unsigned(quadrant_bits - 1 downto 0);
    variable sign : std_ulogic;
  begin
    bin  := unsigned(angle(quadrant_bits - 1 downto 0));
    sign := angle(angle'high);
    if not folded then
      return sign & bin;
    elsif sign = '1' then
      return not bin;
    else
      return bin;
    end if;
  end function;

  signal address                                 : address_t := (others => '0');
  signal data                                    : value_t := (others => '0');
  signal address_outside, data_outside           : std_ulogic := '0';
  signal address_valid, data_valid, output_valid : std_ulogic := '0';

begin

  assert quadrant_bits >= 1
    report "bell_rom: address_bits=" & to_string(address_bits) & " leaves a quadrant without bins; 2 is the least"
    severity failure;

  assert wrap_bits <= 8
    report "bell_rom: wrap_bits=" & to_string(wrap_bits) & " exceeds 8"
    severity failure;

  address_stage : process (clk)
  begin
    if rising_edge(clk) then
      address         <= address_of(ra);
      address_outside <= is_outside(ra);
      address_valid   <= ra_valid and not reset;
    end if;
  end process;

  data_stage : process (clk)
  begin
    if rising_edge(clk) then
      data         <= rom(to_integer(address));
      data_outside <= address_outside;
      data_valid   <= address_valid and not reset;
    end if;
  end process;

  value_stage : process (clk)
  begin
    if rising_edge(clk) then
      value        <= (others => '0') when data_outside = '1' else data;
      output_valid <= data_valid and not reset;
    end if;
  end process;

  value_valid <= output_valid;

end architecture;
