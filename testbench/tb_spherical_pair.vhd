-- SPDX-License-Identifier: MIT
--
-- line_interpolator and bell_rom in a row, the specular part of paper `spherical`, figure 12, up to its multiplier:
-- every pixel's value against the two kernels, at full speed and with random pauses of `step`.
--
-- Spans of 1 to 512 pixels follow each other without a gap: the first pixel of the next takes the place of one step.
-- value_valid is expected exactly the sum of both latencies after each step and at no other time.

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

entity tb_spherical_pair is
  generic (
    runner_cfg      : string;
    phase_bits      : positive;
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

architecture tb of tb_spherical_pair is

  constant latency      : positive := sheen.line_interpolator'latency + sheen.bell_rom'latency;
  constant clock_period : time := 10 ns;
  constant ra_bits      : positive := wrap_bits + address_bits + boolean'pos(folded);
  constant generics     : string :=
    "phase_bits=" & to_string(phase_bits) & ",address_bits=" & to_string(address_bits) & ",data_bits=" &
    to_string(data_bits) & ",exponent_tenths=" & to_string(exponent_tenths) & ",wrap_bits=" &
    to_string(wrap_bits) & ",folded=" & to_string(folded);
  constant path         : string := vector_path(vector_folder, "spherical_pair", generics);

  type expected_t is record
    valid  : std_ulogic;
    value  : unsigned(data_bits - 1 downto 0);
    number : natural;
  end record;
  constant nothing : expected_t := ('0', (others => '0'), 0);
  type expected_vector_t is array (natural range <>) of expected_t;

  signal clk         : std_ulogic := '0';
  signal reset       : std_ulogic := '1';
  signal init, step  : std_ulogic := '0';
  signal sxsb, s     : signed(phase_bits - 1 downto 0) := (others => '0');
  signal ra_valid    : std_ulogic;
  signal ra          : signed(ra_bits - 1 downto 0);
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
    variable start        : std_ulogic;
    variable word         : std_ulogic_vector(phase_bits - 1 downto 0);
    variable value_word   : std_ulogic_vector(data_bits - 1 downto 0);

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
      if run("every_pixel_brings_the_kernels_value") then
        open_vectors(vectors, path, "spherical_pair", count, seed, generics);
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
          read_word(vector, path, number, value_word);
          expected <= ('1', unsigned(value_word), number);
          wait until rising_edge(clk);
        end loop;
        step     <= '0';
        expected <= nothing;
        wait until rising_edge(clk) and compared = count for (latency + 2) * clock_period;
        close_vectors(vectors, path, "spherical_pair", count, compared);
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

  angle : entity sheen.line_interpolator
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

  bell : entity sheen.bell_rom
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
