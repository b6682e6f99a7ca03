-- SPDX-License-Identifier: MIT
--
-- edge_walker against its kernel, clock by clock: a vector holds one clock's inputs and the outputs that stand in it.
--
-- Control bits are compared in every clock, a span while it is pushed, the channel flags while a triangle is loaded.
-- stall_percent is a property of the vectors: the share of clocks without room, job or taken first span.

library ieee;
use ieee.numeric_std.all;
use ieee.std_logic_1164.all;

library std;
use std.textio.all;

library vunit_lib;
context vunit_lib.vunit_context;

library sheen;
use sheen.sheen_pkg.all;

use work.vector_file_pkg.all;

entity tb_edge_walker is
  generic (
    runner_cfg    : string;
    stall_percent : natural;
    count         : positive;
    seed          : positive;
    vector_folder : string
  );
end entity;

architecture tb of tb_edge_walker is

  constant latency      : positive := sheen.edge_walker'latency;
  constant clock_period : time := 10 ns;
  constant generics     : string := "stall_percent=" & to_string(stall_percent);
  constant path         : string := vector_path(vector_folder, "edge_walker", generics);

  constant no_job : job_t := (
    valid => '0', message => '0', leftward => '0', linear => '0', depth => '0', log => "00", code => "00",
    header => (others => '0')
  );

  signal clk         : std_ulogic := '0';
  signal rst         : std_ulogic := '1';
  signal job         : job_t := no_job;
  signal geometry    : geometry_t;
  signal job_taken   : std_ulogic;
  signal room        : std_ulogic := '0';
  signal first_taken : std_ulogic := '0';
  signal push        : std_ulogic;
  signal span        : span_t;
  signal command     : edge_command_t;

begin

  clk <= not clk after clock_period / 2;

  main : process
    file vectors       : text;
    variable vector    : line;
    variable number    : positive := 1;

    impure function next_bit return std_ulogic is
      variable word : std_ulogic;
    begin
      read_word(vector, path, number, word);
      return word;
    end function;

    impure function next_word(bits : positive) return std_ulogic_vector is
      variable word : std_ulogic_vector(bits - 1 downto 0);
    begin
      read_word(vector, path, number, word);
      return word;
    end function;

    impure function next_coordinate return coordinate_t is
    begin
      return unsigned(next_word(coordinate_t'length));
    end function;

    impure function next_phase return phase_t is
    begin
      return unsigned(next_word(phase_t'length));
    end function;

    procedure drive_job is
    begin
      job.valid    <= next_bit;
      job.message  <= next_bit;
      job.leftward <= next_bit;
      job.linear   <= next_bit;
      job.depth    <= next_bit;
      job.code     <= next_word(2);
      job.header   <= next_word(word_t'length);
      geometry.x             <= next_coordinate;
      geometry.y             <= next_coordinate;
      geometry.rows_above    <= next_coordinate;
      geometry.rows_below    <= next_coordinate;
      geometry.kappa         <= next_coordinate;
      geometry.length        <= next_coordinate;
      geometry.m             <= next_coordinate;
      geometry.length_reload <= next_coordinate;
      geometry.m_below       <= next_coordinate;
      geometry.long_phase  <= next_phase;
      geometry.long_step   <= next_phase;
      geometry.upper_phase <= next_phase;
      geometry.upper_step  <= next_phase;
      geometry.lower_phase <= next_phase;
      geometry.lower_step  <= next_phase;
    end procedure;

    procedure compare(got, expected : std_ulogic; name : string) is
    begin
      check_equal(got, expected, path & ":" & to_string(number + 1) & ": " & name);
    end procedure;

    procedure compare(got, expected : coordinate_t; name : string) is
    begin
      check_equal(got, expected, path & ":" & to_string(number + 1) & ": " & name);
    end procedure;

    -- Every word is read, and compared only when it means something.
    procedure compare_outputs is
      variable expected_command : edge_command_t;
      variable expected_push    : std_ulogic;
      variable expected_span    : span_t;
    begin
      compare(job_taken, next_bit, "job_taken");
      expected_command.load   := next_bit;
      expected_command.linear := next_bit;
      expected_command.depth  := next_bit;
      expected_command.step   := next_bit;
      expected_command.carry  := next_bit;
      expected_push           := next_bit;
      expected_span.x         := next_coordinate;
      expected_span.y         := next_coordinate;
      expected_span.length    := next_coordinate;
      expected_span.single    := next_bit;
      expected_span.leftward  := next_bit;
      expected_span.first     := next_bit;
      expected_span.message   := next_bit;
      compare(command.load, expected_command.load, "command.load");
      compare(command.step, expected_command.step, "command.step");
      compare(command.carry, expected_command.carry, "command.carry");
      compare(push, expected_push, "push");
      if expected_command.load = '1' then
        compare(command.linear, expected_command.linear, "command.linear");
        compare(command.depth, expected_command.depth, "command.depth");
      end if;
      if expected_push = '1' then
        compare(span.x, expected_span.x, "span.x");
        compare(span.y, expected_span.y, "span.y");
        compare(span.length, expected_span.length, "span.length");
        compare(span.single, expected_span.single, "span.single");
        compare(span.leftward, expected_span.leftward, "span.leftward");
        compare(span.first, expected_span.first, "span.first");
        compare(span.message, expected_span.message, "span.message");
      end if;
    end procedure;
  begin
    test_runner_setup(runner, runner_cfg);
    check_equal(latency, 1, "the vectors hold the outputs of the clock after the decision");
    wait until rising_edge(clk);

    while test_suite loop
      if run("every_clock_has_the_kernels_outputs") then
        rst <= '0';
        open_vectors(vectors, path, "edge_walker", count, seed, generics);
        for k in 1 to count loop
          number := k;
          read_vector(vectors, path, number, vector);
          drive_job;
          room        <= next_bit;
          first_taken <= next_bit;
          wait until rising_edge(clk);
          compare_outputs;
        end loop;
        close_vectors(vectors, path, "edge_walker", count, number);

      elsif run("reset_drops_the_triangle_under_way") then
        rst <= '0';
        job.valid <= '1';
        geometry.rows_above <= to_unsigned(9, coordinate_t'length);
        geometry.rows_below <= to_unsigned(9, coordinate_t'length);
        geometry.length     <= to_unsigned(1, coordinate_t'length);
        room <= '1';
        wait until rising_edge(clk) and job_taken = '1';
        job.valid <= '0';
        wait until rising_edge(clk) and push = '1' for 10 * clock_period;
        check_equal(push, '1', "push of the first row");
        rst <= '1';
        wait until rising_edge(clk);
        rst <= '0';
        for k in 1 to 20 loop
          wait until rising_edge(clk);
          check_equal(push, '0', "push after reset");
          check_equal(command.step, '0', "command.step after reset");
        end loop;
        job.valid <= '1';
        wait until rising_edge(clk);
        check_equal(job_taken, '1', "job_taken: the next triangle waits for no first span of the dropped one");
      end if;
    end loop;

    test_runner_cleanup(runner);
  end process;

  dut : entity sheen.edge_walker
    port map (
      clk         => clk,
      rst         => rst,
      job         => job,
      geometry    => geometry,
      job_taken   => job_taken,
      room        => room,
      first_taken => first_taken,
      push        => push,
      span        => span,
      command     => command
    );

end architecture;
