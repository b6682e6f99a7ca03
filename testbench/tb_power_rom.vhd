-- SPDX-License-Identifier: MIT
--
-- power_rom against its kernel: every clock's value while words are written, also where they are read. The unit has no
-- clock in which nothing happens, so a pause is one in which nothing is written and t is noise.

library ieee;
use ieee.math_real.all;
use ieee.numeric_std.all;
use ieee.std_logic_1164.all;

library std;
use std.textio.all;

library vunit_lib;
context vunit_lib.vunit_context;

library sheen;
use sheen.sheen_constants_pkg.all;
use sheen.sheen_pkg.all;

use work.vector_file_pkg.all;

entity tb_power_rom is
  generic (
    runner_cfg    : string;
    address_bits  : positive;
    fraction_bits : natural;
    stall_percent : natural;
    count         : positive;
    seed          : positive;
    vector_folder : string
  );
end entity;

architecture tb of tb_power_rom is

  constant latency      : positive := sheen.power_rom'latency;
  constant clock_period : time := 10 ns;
  constant t_bits       : positive := log_integer_bits + address_bits - power_integer_bits;
  constant generics     : string :=
    "address_bits=" & to_string(address_bits) & ",fraction_bits=" & to_string(fraction_bits);
  constant path         : string := vector_path(vector_folder, "power_rom", generics);

  subtype value_t is unsigned(component_bits + fraction_bits - 1 downto 0);

  type expected_t is record
    valid  : std_ulogic;
    known  : std_ulogic;
    value  : value_t;
    number : natural;
  end record;
  constant nothing : expected_t := ('0', '0', (others => '0'), 0);
  type expected_vector_t is array (natural range <>) of expected_t;
  constant no_write : table_write_t := ('0', '0', (others => '0'), (others => '0'));

  signal clk      : std_ulogic := '0';
  signal write    : table_write_t := no_write;
  signal bank     : std_ulogic := '0';
  signal t        : signed(t_bits - 1 downto 0) := (others => '0');
  signal value    : value_t;
  signal expected : expected_t := nothing;
  signal compared : natural := 0;

begin

  clk <= not clk after clock_period / 2;

  main : process
    file vectors          : text;
    variable vector       : line;
    variable seed1, seed2 : positive := seed;
    variable write_valid  : std_ulogic;
    variable write_bank   : std_ulogic;
    variable write_place  : std_ulogic_vector(address_bits - 3 downto 0);
    variable write_data   : word_t;
    variable bank_word    : std_ulogic;
    variable t_word       : std_ulogic_vector(t_bits - 1 downto 0);
    variable known        : std_ulogic;
    variable value_word   : std_ulogic_vector(value_t'range);

    impure function chance(percent : natural) return boolean is
      variable random : real;
    begin
      uniform(seed1, seed2, random);
      return random * 100.0 < real(percent);
    end function;
  begin
    test_runner_setup(runner, runner_cfg);
    while test_suite loop
      if run("every_clock_brings_the_kernels_value") then
        open_vectors(vectors, path, "power_rom", count, seed, generics);
        for number in 1 to count loop
          while chance(stall_percent) loop
            write <= no_write;
            for i in t'range loop
              t(i) <= '1' when chance(50) else '0';
            end loop;
            expected <= nothing;
            wait until rising_edge(clk);
          end loop;
          read_vector(vectors, path, number, vector);
          read_word(vector, path, number, write_valid);
          read_word(vector, path, number, write_bank);
          read_word(vector, path, number, write_place);
          read_word(vector, path, number, write_data);
          read_word(vector, path, number, bank_word);
          read_word(vector, path, number, t_word);
          read_word(vector, path, number, known);
          read_word(vector, path, number, value_word);
          write    <= (write_valid, write_bank, resize(unsigned(write_place), power_word_bits), write_data);
          bank     <= bank_word;
          t        <= signed(t_word);
          expected <= ('1', known, unsigned(value_word), number);
          wait until rising_edge(clk);
        end loop;
        write    <= no_write;
        expected <= nothing;
        wait until rising_edge(clk) and compared = count for (latency + 2) * clock_period;
        close_vectors(vectors, path, "power_rom", count, compared);
      end if;
    end loop;
    test_runner_cleanup(runner);
  end process;

  check_outputs : process (clk)
    variable pipe : expected_vector_t(1 to latency) := (others => nothing);
  begin
    if rising_edge(clk) then
      if pipe(latency).valid = '1' then
        if pipe(latency).known = '1' then
          check_equal(value, pipe(latency).value, path & ":" & to_string(pipe(latency).number + 1) & ": value");
        end if;
        compared <= compared + 1;
      end if;
      pipe := expected & pipe(1 to latency - 1);
    end if;
  end process;

  dut : entity sheen.power_rom
    generic map (
      address_bits  => address_bits,
      fraction_bits => fraction_bits
    )
    port map (
      clk   => clk,
      write => write,
      bank  => bank,
      t     => t,
      value => value
    );

end architecture;
