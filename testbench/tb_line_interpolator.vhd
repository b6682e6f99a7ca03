-- SPDX-License-Identifier: MIT
--
-- line_interpolator against its kernel: every step's ra, at full speed and with random pauses of `step`.
--
-- In a pause the inputs carry noise, which must change nothing. ra_valid is expected exactly `latency` clocks after
-- each step and at no other time.

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

entity tb_line_interpolator is
  generic (
    runner_cfg    : string;
    phase_bits    : positive;
    ra_bits       : positive;
    stall_percent : natural;
    count         : positive;
    seed          : positive;
    vector_folder : string
  );
end entity;

architecture tb of tb_line_interpolator is

  constant latency       : positive := sheen.line_interpolator'latency;
  constant clock_period  : time := 10 ns;
  constant generics      : string := "phase_bits=" & to_string(phase_bits) & ",ra_bits=" & to_string(ra_bits);
  constant path          : string := vector_path(vector_folder, "line_interpolator", generics);

  type expected_t is record
    valid  : std_ulogic;
    ra     : signed(ra_bits - 1 downto 0);
    number : natural;
  end record;
  constant nothing : expected_t := ('0', (others => '0'), 0);
  type expected_vector_t is array (natural range <>) of expected_t;

  signal clk        : std_ulogic := '0';
  signal reset      : std_ulogic := '1';
  signal init, step : std_ulogic := '0';
  signal sxsb, s    : signed(phase_bits - 1 downto 0) := (others => '0');
  signal ra_valid   : std_ulogic;
  signal ra         : signed(ra_bits - 1 downto 0);

  signal expected : expected_t := nothing;
  signal compared : natural := 0;

begin

  clk <= not clk after clock_period / 2;

  main : process
    file vectors          : text;
    variable vector       : line;
    variable seed1, seed2 : positive := seed;
    variable word         : std_ulogic_vector(phase_bits - 1 downto 0);
    variable ra_word      : std_ulogic_vector(ra_bits - 1 downto 0);
    variable start        : std_ulogic;

    impure function chance(percent : natural) return boolean is
      variable random : real;
    begin
      uniform(seed1, seed2, random);
      return random * 100.0 < real(percent);
    end function;

    impure function random_word return signed is
      variable bits : signed(phase_bits - 1 downto 0);
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
      if run("every_step_brings_the_kernels_ra") then
        open_vectors(vectors, path, "line_interpolator", count, seed, generics);
        for number in 1 to count loop
          while chance(stall_percent) loop
            init     <= '1' when chance(50) else '0';
            step     <= '0';
            sxsb     <= random_word;
            s        <= random_word;
            expected <= nothing;
            wait until rising_edge(clk);
          end loop;
          read_vector(vectors, path, number, vector);
          read_word(vector, path, number, start);
          init <= start;
          step <= '1';
          read_word(vector, path, number, word);
          sxsb <= signed(word);
          read_word(vector, path, number, word);
          s    <= signed(word);
          read_word(vector, path, number, ra_word);
          expected <= ('1', signed(ra_word), number);
          wait until rising_edge(clk);
        end loop;
        step     <= '0';
        expected <= nothing;
        wait until rising_edge(clk) and compared = count for (latency + 2) * clock_period;
        close_vectors(vectors, path, "line_interpolator", count, compared);

      elsif run("reset_clears_angle_and_valid") then
        init <= '1';
        step <= '1';
        sxsb <= (others => '1');
        expected <= ('1', (others => '1'), 1);
        wait until rising_edge(clk);
        reset    <= '1';
        expected <= nothing;
        wait until rising_edge(clk);
        wait for latency * clock_period;
        check_equal(ra_valid, '0', "ra_valid in reset");
        check_equal(ra, 0, "ra in reset");
      end if;
    end loop;

    test_runner_cleanup(runner);
  end process;

  check_outputs : process (clk)
    variable pipe : expected_vector_t(1 to latency) := (others => nothing);
  begin
    if rising_edge(clk) then
      check_equal(ra_valid, pipe(latency).valid, path & ":" & to_string(pipe(latency).number + 1) & ": ra_valid");
      if pipe(latency).valid = '1' then
        check_equal(ra, pipe(latency).ra, path & ":" & to_string(pipe(latency).number + 1) & ": ra");
        compared <= compared + 1;
      end if;
      pipe := expected & pipe(1 to latency - 1);
    end if;
  end process;

  dut : entity sheen.line_interpolator
    generic map (
      phase_bits => phase_bits,
      ra_bits    => ra_bits
    )
    port map (
      clk      => clk,
      reset    => reset,
      init     => init,
      step     => step,
      sxsb     => sxsb,
      s        => s,
      ra_valid => ra_valid,
      ra       => ra
    );

end architecture;
