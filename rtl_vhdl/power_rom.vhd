-- SPDX-License-Identifier: MIT
--
-- power_rom: the loadable exponent table of paper `fast-phong`, section 3: what a cosine becomes as a highlight.
--
-- Two banks: one is read while the other is loaded, and `bank` says which one is read, so that a new shininess never
-- disturbs a pixel in flight. A word holds four entries, entry 4w + k in its bits 8k+7..8k. The angle's cosine comes as
-- t = 16*cos:
--
--   t < 0      entry 0
--   t >= 16    the last entry: a polynomial may pass 1
--
--       t   | s | beyond | word address | lane |     s8.(address_bits - 4)
--
-- Four stages, as exp2_rom: address register, memory, the memory's output register, entry. One block RAM of 512 x 32
-- on ECP5 and four of 512 x 8 on iCE40 for the paper's 1 KB.
-- Kernel: hls/include/sheen/hls/power_rom.hpp, equal to the bit.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library sheen;
  use sheen.sheen_constants_pkg.all;
  use sheen.sheen_pkg.all;

entity power_rom is
  generic (
    -- A bank has 2**address_bits entries: 10 are the 1 KB of the paper.
    address_bits : positive := power_address_bits;
    -- Of the value; an entry has none.
    fraction_bits : natural := colour_sum_fraction_bits
  );
  port (
    clk   : in std_ulogic;
    write : in table_write_t;                                               -- into either bank
    bank  : in std_ulogic;                                                  -- the one that is read
    t     : in signed(log_integer_bits + address_bits - 5 downto 0);        -- s8.(address_bits - 4)
    value : out unsigned(component_bits + fraction_bits - 1 downto 0)       -- u8.fraction_bits
  );

  -- value follows t by this many clocks.
  attribute latency : positive;
  attribute latency of power_rom : entity is 4;
end entity power_rom;

architecture rtl of power_rom is

  constant lane_bits : positive := 2;

  subtype address_t is unsigned(address_bits - 1 downto 0);
  subtype lane_t is unsigned(lane_bits - 1 downto 0);

  type memory_t is array (0 to 2 ** (address_bits - lane_bits + 1) - 1) of word_t;

  signal banks         : memory_t := (others => (others => '0'));
  signal write_place   : unsigned(address_bits - lane_bits downto 0);
  signal address       : unsigned(address_bits - lane_bits downto 0) := (others => '0');
  signal address_lane  : lane_t := (others => '0');
  signal memory        : word_t := (others => '0');
  signal memory_lane   : lane_t := (others => '0');
  signal fetched        : word_t := (others => '0');
  signal fetched_lane   : lane_t := (others => '0');

begin

  write_place <= write.bank & write.address(address_bits - lane_bits - 1 downto 0);

  address_stage : process (clk) is
    variable entry_number : address_t;
  begin
    if rising_edge(clk) then
      entry_number := unsigned(t(address_bits - 1 downto 0));
      if t(t'high) then
        entry_number := (others => '0');
      elsif or t(t'high - 1 downto address_bits) then
        entry_number := (others => '1');
      end if;
      address      <= bank & entry_number(address_bits - 1 downto lane_bits);
      address_lane <= entry_number(lane_bits - 1 downto 0);
    end if;
  end process address_stage;

  memory_stage : process (clk) is
  begin
    if rising_edge(clk) then
      if write.valid then
        banks(to_integer(write_place)) <= write.data;
      end if;
      memory <= banks(to_integer(address));
    end if;
  end process memory_stage;

  fetched_stage : process (clk) is
  begin
    if rising_edge(clk) then
      memory_lane <= address_lane;
      fetched      <= memory;
      fetched_lane <= memory_lane;
    end if;
  end process fetched_stage;

  entry_stage : process (clk) is
    variable pair   : std_ulogic_vector(2 * component_bits - 1 downto 0);
    variable chosen : std_ulogic_vector(component_bits - 1 downto 0);
  begin
    if rising_edge(clk) then
      -- No case: GHDL 2.0 writes one into Verilog without its last choice, `others`.
      pair := fetched(15 downto 0);
      if fetched_lane(1) then
        pair := fetched(31 downto 16);
      end if;
      chosen := pair(7 downto 0);
      if fetched_lane(0) then
        chosen := pair(15 downto 8);
      end if;
      value <= shift_left(resize(unsigned(chosen), value'length), fraction_bits);
    end if;
  end process entry_stage;

end architecture rtl;
