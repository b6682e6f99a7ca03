-- SPDX-License-Identifier: MIT
--
-- exp2_rom: the highlight 2**(8 - z) in 8-bit steps, by one table read and a shift (Sheen's log-quadratic).
--
--   z < 0       taken as 0: the highlight's peak
--   fraction    address of the table, one octave
--   integer     the table's value goes right by it; from 16 on nothing is left
--
--       z   | s | far | shift | address |     s8.address_bits
--
-- No multiplier: the exponent n, and the highlight's strength, are in z. Four stages: address register, data register
-- (both plain, so that block RAM can take them in), shift by 0 to 3, shift by 0, 4, 8 or 12.
-- Kernel: hls/include/sheen/hls/exp2_rom.hpp, equal to the bit.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library sheen;
  use sheen.sheen_constants_pkg.all;
  use sheen.exp2_rom_pkg.all;

entity exp2_rom is
  generic (
    -- The table has 2**address_bits words of data_bits bits.
    address_bits : positive := exp2_address_bits;
    data_bits    : positive := exp2_data_bits;
    -- Of the value; at least data_bits - 8.
    fraction_bits : natural := colour_sum_fraction_bits
  );
  port (
    clk   : in std_ulogic;
    z     : in signed(log_integer_bits + address_bits - 1 downto 0);        -- s8.address_bits
    value : out unsigned(component_bits + fraction_bits - 1 downto 0)       -- u8.fraction_bits
  );

  -- value follows z by this many clocks.
  attribute latency : positive;
  attribute latency of exp2_rom : entity is 4;
end entity exp2_rom;

architecture rtl of exp2_rom is

  constant shift_bits : positive := 4;
  constant spare_bits : integer  := fraction_bits - (data_bits - component_bits);

  subtype address_t is unsigned(address_bits - 1 downto 0);
  subtype data_t is unsigned(data_bits - 1 downto 0);
  subtype value_t is unsigned(component_bits + fraction_bits - 1 downto 0);
  subtype shift_t is unsigned(shift_bits - 1 downto 0);

  type rom_t is array (0 to 2 ** address_bits - 1) of data_t;

  function rom_contents return rom_t is
    constant octave : exp2_table_t(0 to 2 ** address_bits - 1) := exp2_table(address_bits, data_bits);
    variable contents : rom_t;
  begin
    for bin in octave'range loop
      contents(bin) := to_unsigned(octave(bin), data_bits);
    end loop;
    return contents;
  end function rom_contents;

  constant rom : rom_t := rom_contents;

  signal address       : address_t := (others => '0');
  signal address_shift : shift_t := (others => '0');
  signal address_none  : std_ulogic := '0';
  signal data          : data_t := (others => '0');
  signal data_shift    : shift_t := (others => '0');
  signal data_none     : std_ulogic := '0';
  signal near          : value_t := (others => '0');
  signal near_shift    : unsigned(1 downto 0) := "00";
  signal near_none     : std_ulogic := '0';

begin

  assert spare_bits >= 0
    report "exp2_rom: fraction_bits=" & integer'image(fraction_bits) & " can't hold an entry of data_bits="
           & integer'image(data_bits) & "; at least data_bits - 8 are needed"
    severity failure;

  address_stage : process (clk) is
    constant far_high : positive := z'high - 1;
    constant far_low  : positive := address_bits + shift_bits;
  begin
    if rising_edge(clk) then
      address       <= unsigned(z(address_bits - 1 downto 0));
      address_shift <= unsigned(z(far_low - 1 downto address_bits));
      address_none  <= or z(far_high downto far_low);
      if z(z'high) then
        address       <= (others => '0');
        address_shift <= (others => '0');
        address_none  <= '0';
      end if;
    end if;
  end process address_stage;

  data_stage : process (clk) is
  begin
    if rising_edge(clk) then
      data       <= rom(to_integer(address));
      data_shift <= address_shift;
      data_none  <= address_none;
    end if;
  end process data_stage;

  near_stage : process (clk) is
    variable whole : value_t;
  begin
    if rising_edge(clk) then
      whole := shift_left(resize(data, value_t'length), spare_bits);
      -- No case: GHDL 2.0 writes one into Verilog without its last choice, `others`.
      if data_shift(1) then
        whole := shift_right(whole, 2);
      end if;
      if data_shift(0) then
        whole := shift_right(whole, 1);
      end if;
      near       <= whole;
      near_shift <= data_shift(3 downto 2);
      near_none  <= data_none;
    end if;
  end process near_stage;

  value_stage : process (clk) is
    variable shifted : value_t;
  begin
    if rising_edge(clk) then
      shifted := near;
      if near_shift(1) then
        shifted := shift_right(shifted, 8);
      end if;
      if near_shift(0) then
        shifted := shift_right(shifted, 4);
      end if;
      value <= shifted;
      if near_none then
        value <= (others => '0');
      end if;
    end if;
  end process value_stage;

end architecture rtl;
