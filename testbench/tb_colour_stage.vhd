-- SPDX-License-Identifier: MIT
--
-- colour_stage against its kernel: valid, and with it word and fence, in every clock; fragments without a gap and with
-- random pauses.
--
-- The kernel's channels are colour_width and depth_width bits wide; the unit gets their integer parts.

library ieee;
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

entity tb_colour_stage is
  generic (
    runner_cfg    : string;
    colour_width  : positive;
    depth_width   : positive;
    stall_percent : natural;
    count         : positive;
    seed          : positive;
    vector_folder : string
  );
end entity;

architecture tb of tb_colour_stage is

  constant latency      : positive := sheen.colour_stage'latency;
  constant clock_period : time := 10 ns;
  constant generics     : string :=
    "colour_width=" & to_string(colour_width) & ",depth_width=" & to_string(depth_width) & ",stall_percent=" &
    to_string(stall_percent);
  constant path         : string := vector_path(vector_folder, "colour_stage", generics);
  constant no_fragment  : fragment_t := (
    log => "00", x => (others => '0'), y => (others => '0'), tail => (others => '0'), others => '0');

  subtype colour_t is std_ulogic_vector(colour_integer_bits - 1 downto 0);

  signal clk              : std_ulogic := '0';
  signal rst              : std_ulogic := '1';
  signal description      : word_vector_t(0 to query_reply_words - 1) := (others => (others => '0'));
  signal fragment         : fragment_t := no_fragment;
  signal red, green, blue : colour_t := (others => '0');
  signal depth            : std_ulogic_vector(depth_bits - 1 downto 0) := (others => '0');
  signal valid, fence     : std_ulogic;
  signal word             : pixel_word_t;

begin

  clk <= not clk after clock_period / 2;

  main : process
    file vectors           : text;
    variable vector        : line;
    variable number        : positive;
    variable expected_word : pixel_word_t;

    impure function next_bits(bits : positive) return std_ulogic_vector is
      variable bits_word : std_ulogic_vector(bits - 1 downto 0);
    begin
      read_word(vector, path, number, bits_word);
      return bits_word;
    end function;

    impure function next_bit return std_ulogic is
      variable bit_word : std_ulogic;
    begin
      read_word(vector, path, number, bit_word);
      return bit_word;
    end function;

    impure function next_fragment return fragment_t is
      variable read : fragment_t;
    begin
      read.valid   := next_bit;
      read.message := next_bit;
      read.query   := next_bit;
      read.x       := unsigned(next_bits(coordinate_bits));
      read.y       := unsigned(next_bits(coordinate_bits));
      read.tail    := unsigned(next_bits(coordinate_bits));
      return read;
    end function;

    procedure expect(name : string; got, expected : std_ulogic) is
    begin
      check_equal(got, expected, path & ":" & to_string(number + 1) & ": " & name);
    end procedure;

    variable expected_fence : std_ulogic;
  begin
    test_runner_setup(runner, runner_cfg);
    wait until rising_edge(clk);
    rst <= '0';
    wait until rising_edge(clk);

    while test_suite loop
      if run("every_clock_shows_the_kernels_word") then
        open_vectors(vectors, path, "colour_stage", count, seed, generics);
        for vector_number in 1 to count loop
          number := vector_number;
          read_vector(vectors, path, number, vector);
          for k in description'range loop
            description(k) <= next_bits(word_bits);
          end loop;
          fragment <= next_fragment;
          red      <= next_bits(colour_integer_bits);
          green    <= next_bits(colour_integer_bits);
          blue     <= next_bits(colour_integer_bits);
          depth    <= next_bits(depth_bits);
          wait until rising_edge(clk);
          expect("valid", valid, next_bit);
          expected_fence := next_bit;
          expected_word  := next_bits(pixel_bits);
          if valid = '1' then
            expect("fence", fence, expected_fence);
            check_equal(word, expected_word, path & ":" & to_string(number + 1) & ": word");
          end if;
        end loop;
        close_vectors(vectors, path, "colour_stage", count, count);

      elsif run("a_word_is_valid_after_the_declared_latency") then
        fragment.valid <= '1';
        wait until rising_edge(clk);
        fragment.valid <= '0';
        for clock in 1 to latency loop
          wait until rising_edge(clk);
          check_equal(valid, to_std_ulogic(clock = latency),
                      "valid " & to_string(clock) & " clocks after the fragment");
        end loop;

      elsif run("reset_empties_the_pipeline") then
        fragment.valid <= '1';
        for clock in 1 to latency loop
          wait until rising_edge(clk);
        end loop;
        rst            <= '1';
        fragment.valid <= '0';
        wait until rising_edge(clk);
        rst            <= '0';
        for clock in 1 to latency + 1 loop
          wait until rising_edge(clk);
          check_equal(valid, '0', "valid after reset");
        end loop;
      end if;
    end loop;

    test_runner_cleanup(runner);
  end process;

  dut : entity sheen.colour_stage
    port map (
      clk         => clk,
      rst         => rst,
      description => description,
      fragment    => fragment,
      red         => red,
      green       => green,
      blue        => blue,
      depth       => depth,
      valid       => valid,
      fence       => fence,
      word        => word
    );

end architecture;
