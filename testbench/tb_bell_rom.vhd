-- SPDX-License-Identifier: MIT
--
-- bell_rom against its kernel: every angle's value, at full speed and with random pauses of ra_valid.
--
-- In a pause ra carries noise, which must change nothing. value_valid is expected exactly `latency` clocks after each
-- ra_valid and at no other time.

library ieee;
use ieee.math_real.all;
use ieee.numeric_std.all;
use ieee.std_logic_1164.all;

library std;
use std.textio.all;

library vunit_lib;
context vunit_lib.vunit_context;

library sheen;

use work.vector_file_pkg.all;

entity tb_bell_rom is
  generic (
    runner_cfg      : string;
    address_bits    : positive;
    data_bits       : positive;
    exponent_tenths : positive;
    wrap_bits       : natural;
    folded          : boolean;
    stall_percent   : natural;
    count           : positive;
    seed            : positive;
    vector_folder   : string
  );
end entity;

architecture tb of tb_bell_rom is

  constant latency      : positive := sheen.bell_rom'latency;
  constant clock_period : time := 10 ns;
  constant ra_bits      : positive := wrap_bits + address_bits + boolean'pos(folded);
  constant generics     : string :=
    "address_bits=" & to_string(address_bits) & ",data_bits=" & to_string(data_bits) & ",exponent_tenths=" &
    to_string(exponent_tenths) & ",wrap_bits=" & to_string(wrap_bits) & ",folded=" & to_string(folded);
  constant path         : string := vector_path(vector_folder, "bell_rom", generics);

  type expected_t is record
    valid  : std_ulogic;
    value  : unsigned(data_bits - 1 downto 0);
    number : natural;
  end record;
  constant nothing : expected_t := ('0', (others => '0'), 0);
  type expected_vector_t is array (natural range <>) of expected_t;

  signal clk         : std_ulogic := '0';
  signal reset       : std_ulogic := '1';
  signal ra_valid    : std_ulogic := '0';
  signal ra          : signed(ra_bits - 1 downto 0) := (others => '0');
  signal value_valid : std_ulogic;
  signal value       : unsigned(data_bits - 1 downto 0);

  signal expected : expected_t := nothing;
  signal compared : natural := 0;

begin

  clk <= not clk after clock_period / 2;

  main : process
    file vectors          : text;
    variable vector       : line;
    variable seed1, seed2 : positive := seed;
    variable ra_word      : std_ulogic_vector(ra_bits - 1 downto 0);
    variable value_word   : std_ulogic_vector(data_bits - 1 downto 0);

    impure function chance(percent : natural) return boolean is
      variable random : real;
    begin
      uniform(seed1, seed2, random);
      return random * 100.0 < real(percent);
    end function;

    impure function random_word return signed is
      variable bits : signed(ra_bits - 1 downto 0);
    begin
      for i in bits'range loop
        bits(i) := '1' when chance(50) else '0';
      end loop;
      return bits;
    end function;
  begin
    test_runner_setup(runner, runner_cfg);
    wait until rising_edge(clk);
    reset <= '0';

    while test_suite loop
      if run("every_angle_brings_the_kernels_value") then
        open_vectors(vectors, path, "bell_rom", count, seed, generics);
        for number in 1 to count loop
          while chance(stall_percent) loop
            ra_valid <= '0';
            ra       <= random_word;
            expected <= nothing;
            wait until rising_edge(clk);
          end loop;
          read_vector(vectors, path, number, vector);
          read_word(vector, path, number, ra_word);
          read_word(vector, path, number, value_word);
          ra_valid <= '1';
          ra       <= signed(ra_word);
          expected <= ('1', unsigned(value_word), number);
          wait until rising_edge(clk);
        end loop;
        ra_valid <= '0';
        expected <= nothing;
        wait until rising_edge(clk) and compared = count for (latency + 2) * clock_period;
        close_vectors(vectors, path, "bell_rom", count, compared);

      elsif run("reset_empties_the_pipeline") then
        -- Every stage holds an angle, and one more arrives, at the edge that resets: none may come out.
        ra_valid <= '1';
        for stage in 1 to latency - 1 loop
          wait until rising_edge(clk);
        end loop;
        reset <= '1';
        wait until rising_edge(clk);
        ra_valid <= '0';
        reset    <= '0';
        for clock in 1 to latency + 1 loop
          wait until rising_edge(clk);
          check_equal(value_valid, '0', "value_valid, " & to_string(clock) & " clocks after the reset");
        end loop;
      end if;
    end loop;

    test_runner_cleanup(runner);
  end process;

  check_outputs : process (clk)
    variable pipe : expected_vector_t(1 to latency) := (others => nothing);
  begin
    if rising_edge(clk) then
      check_equal(value_valid, pipe(latency).valid, path & ":" & to_string(pipe(latency).number + 1) & ": value_valid");
      if pipe(latency).valid = '1' then
        check_equal(value, pipe(latency).value, path & ":" & to_string(pipe(latency).number + 1) & ": value");
        compared <= compared + 1;
      end if;
      pipe := expected & pipe(1 to latency - 1);
    end if;
  end process;

  dut : entity sheen.bell_rom
    generic map (
      address_bits    => address_bits,
      data_bits       => data_bits,
      exponent_tenths => exponent_tenths,
      wrap_bits       => wrap_bits,
      folded          => folded
    )
    port map (
      clk         => clk,
      reset       => reset,
      ra_valid    => ra_valid,
      ra          => ra,
      value_valid => value_valid,
      value       => value
    );

end architecture;
