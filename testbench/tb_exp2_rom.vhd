-- SPDX-License-Identifier: MIT
--
-- exp2_rom against its kernel: every z's value, at full speed and with noise between the vectors.

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

use work.vector_file_pkg.all;

entity tb_exp2_rom is
  generic (
    runner_cfg    : string;
    address_bits  : positive;
    data_bits     : positive;
    fraction_bits : natural;
    stall_percent : natural;
    count         : positive;
    seed          : positive;
    vector_folder : string
  );
end entity;

architecture tb of tb_exp2_rom is

  constant latency      : positive := sheen.exp2_rom'latency;
  constant clock_period : time := 10 ns;
  constant z_bits       : positive := log_integer_bits + address_bits;
  constant generics     : string :=
    "address_bits=" & to_string(address_bits) & ",data_bits=" & to_string(data_bits) & ",fraction_bits=" &
    to_string(fraction_bits);
  constant path         : string := vector_path(vector_folder, "exp2_rom", generics);

  subtype value_t is unsigned(component_bits + fraction_bits - 1 downto 0);

  type expected_t is record
    valid  : std_ulogic;
    value  : value_t;
    number : natural;
  end record;
  constant nothing : expected_t := ('0', (others => '0'), 0);
  type expected_vector_t is array (natural range <>) of expected_t;

  signal clk      : std_ulogic := '0';
  signal z        : signed(z_bits - 1 downto 0) := (others => '0');
  signal value    : value_t;
  signal expected : expected_t := nothing;
  signal compared : natural := 0;

begin

  clk <= not clk after clock_period / 2;

  main : process
    file vectors          : text;
    variable vector       : line;
    variable seed1, seed2 : positive := seed;
    variable z_word       : std_ulogic_vector(z_bits - 1 downto 0);
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
      if run("every_z_brings_the_kernels_value") then
        open_vectors(vectors, path, "exp2_rom", count, seed, generics);
        for number in 1 to count loop
          while chance(stall_percent) loop
            for i in z'range loop
              z(i) <= '1' when chance(50) else '0';
            end loop;
            expected <= nothing;
            wait until rising_edge(clk);
          end loop;
          read_vector(vectors, path, number, vector);
          read_word(vector, path, number, z_word);
          read_word(vector, path, number, value_word);
          z        <= signed(z_word);
          expected <= ('1', unsigned(value_word), number);
          wait until rising_edge(clk);
        end loop;
        expected <= nothing;
        wait until rising_edge(clk) and compared = count for (latency + 2) * clock_period;
        close_vectors(vectors, path, "exp2_rom", count, compared);
      end if;
    end loop;
    test_runner_cleanup(runner);
  end process;

  check_outputs : process (clk)
    variable pipe : expected_vector_t(1 to latency) := (others => nothing);
  begin
    if rising_edge(clk) then
      if pipe(latency).valid = '1' then
        check_equal(value, pipe(latency).value, path & ":" & to_string(pipe(latency).number + 1) & ": value");
        compared <= compared + 1;
      end if;
      pipe := expected & pipe(1 to latency - 1);
    end if;
  end process;

  dut : entity sheen.exp2_rom
    generic map (
      address_bits  => address_bits,
      data_bits     => data_bits,
      fraction_bits => fraction_bits
    )
    port map (
      clk   => clk,
      z     => z,
      value => value
    );

end architecture;
