-- SPDX-License-Identifier: MIT
--
-- line_interpolator: the angle register of one span (paper `spherical`, section 4 and its printed entity).
--
-- Along a span the angle that a bell table is read with is linear, xi(X) = s*X + b, so one addition a pixel makes it:
--
--   xi(X_start) = sxsb = s*X_start + b,     xi(X+1) = xi(X) + s     (modulo 2**phase_bits).
--
--                 +-------------------------+
--                 |   +-----+ add_out       |
--           s ----(-->|  +  |---->|\        |
--                 +-->|     |     | | mpx   +-----+
--                     +-----+     | |------>| reg |--+--> top ra_bits bits: ra
--        sxsb ------------------->|/        +-----+  |
--                               init   step ---^     +--> back to the adder
--
-- The addition is exact: X steps after an init the register holds sxsb + X*s modulo 2**phase_bits, for any two words.
-- If the host rounds both to nearest, the angle is off by at most (X+1)/2 units of the register's last place.
--
-- What differs from the printed entity:
--   * The printed text does not compile: its port list ends in a semicolon, "DOWNT0" is misspelt, and a conditional
--     assignment on step'EVENT stands outside any process. ra is declared 12 bits wide and assigned 6; here it has its
--     own width.
--   * The text calls the increment s in one place and b (beside figure 12) in another; it is s.
--   * step was the register's clock; here it enables the register for one rising edge of clk, and ra_valid tells that
--     this edge brought a new ra. init still acts only together with step.
--   * The delays t_mpx, t_add and t_reg (5, 10 and 5 ns) describe one device of 1999: docs/units/line_interpolator.md.
--
-- Kernel: hls/include/sheen/hls/line_interpolator.hpp, equal to the bit. In the formats below w is the number of wrap
-- bits of the bell_rom that follows; the unit of an angle is the quadrant, pi/2 of the table's cosine.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity line_interpolator is
  generic (
    -- Width of the angle; preset `paper`: 12.
    phase_bits : positive := 12;
    -- Width of ra: one sign bit, w wrap bits, the bins of a quadrant; preset `paper`: 6.
    ra_bits : positive := 6
  );
  port (
    clk      : in  std_ulogic;
    reset    : in  std_ulogic;
    init     : in  std_ulogic;
    step     : in  std_ulogic;
    sxsb     : in  signed(phase_bits - 1 downto 0); -- s(1+w).(phase_bits-1-w), quadrants
    s        : in  signed(phase_bits - 1 downto 0); -- s(1+w).(phase_bits-1-w), quadrants a pixel
    ra_valid : out std_ulogic;
    ra       : out signed(ra_bits - 1 downto 0)     -- s(1+w).(ra_bits-1-w), quadrants, rounded down
  );

  -- ra and ra_valid follow step by this many clocks.
  attribute latency : positive;
  attribute latency of line_interpolator : entity is 1;
end entity;

architecture rtl of line_interpolator is

  signal add_out, mpx_out : signed(phase_bits - 1 downto 0);
  signal reg_out          : signed(phase_bits - 1 downto 0) := (others => '0');
  signal valid            : std_ulogic := '0';

begin

  assert ra_bits <= phase_bits
    report "line_interpolator: ra_bits=" & to_string(ra_bits) & " exceeds phase_bits=" & to_string(phase_bits)
    severity failure;

  add_out <= reg_out + s;
  mpx_out <= sxsb when init = '1' else add_out;

  phase_register : process (clk)
  begin
    if rising_edge(clk) then
      if step = '1' then
        reg_out <= mpx_out;
      end if;
      valid <= step;
      if reset = '1' then
        reg_out <= (others => '0');
        valid   <= '0';
      end if;
    end if;
  end process;

  ra       <= reg_out(phase_bits - 1 downto phase_bits - ra_bits);
  ra_valid <= valid;

end architecture;
