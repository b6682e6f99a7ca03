-- SPDX-License-Identifier: MIT
--
-- span_walker against its kernel: head_taken, commands and fragments in every clock, at full speed and with random
-- pauses of the span queue and of `go`. Fields are compared while their valid bit is 1.

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

entity tb_span_walker is
  generic (
    runner_cfg    : string;
    stall_percent : natural;
    count         : positive;
    seed          : positive;
    vector_folder : string
  );
end entity;

architecture tb of tb_span_walker is

  constant latency      : positive := sheen.span_walker'latency;
  constant clock_period : time := 10 ns;
  constant generics     : string := "stall_percent=" & to_string(stall_percent);
  constant path         : string := vector_path(vector_folder, "span_walker", generics);
  constant no_span      : span_t := (
    x => (others => '0'), y => (others => '0'), length => (others => '0'), others => '0');

  signal clk                        : std_ulogic := '0';
  signal rst                        : std_ulogic := '1';
  signal head_valid, go, head_taken : std_ulogic := '0';
  signal head                       : span_t := no_span;
  signal command                    : span_command_t;
  signal fragment                   : fragment_t;

begin

  clk <= not clk after clock_period / 2;

  main : process
    file vectors             : text;
    variable vector          : line;
    variable number          : positive;
    variable loaded, drawn   : boolean;

    impure function next_bit return std_ulogic is
      variable word : std_ulogic;
    begin
      read_word(vector, path, number, word);
      return word;
    end function;

    impure function next_coordinate return coordinate_t is
      variable word : std_ulogic_vector(coordinate_bits - 1 downto 0);
    begin
      read_word(vector, path, number, word);
      return unsigned(word);
    end function;

    procedure expect(name : string; got : std_ulogic; compared : boolean := true) is
      constant word : std_ulogic := next_bit;
    begin
      if compared then
        check_equal(got, word, path & ":" & to_string(number + 1) & ": " & name);
      end if;
    end procedure;

    procedure expect(name : string; got : coordinate_t; compared : boolean) is
      constant word : coordinate_t := next_coordinate;
    begin
      if compared then
        check_equal(got, word, path & ":" & to_string(number + 1) & ": " & name);
      end if;
    end procedure;
  begin
    test_runner_setup(runner, runner_cfg);
    wait until rising_edge(clk);
    rst <= '0';
    wait until rising_edge(clk);

    while test_suite loop
      if run("every_clock_shows_the_kernels_commands_and_fragments") then
        open_vectors(vectors, path, "span_walker", count, seed, generics);
        for vector_number in 1 to count loop
          number := vector_number;
          read_vector(vectors, path, number, vector);
          head_valid    <= next_bit;
          head.x        <= next_coordinate;
          head.y        <= next_coordinate;
          head.length   <= next_coordinate;
          head.single   <= next_bit;
          head.leftward <= next_bit;
          head.first    <= next_bit;
          head.message  <= next_bit;
          go            <= next_bit;
          wait until rising_edge(clk);
          expect("head_taken", head_taken);
          loaded := command.load = '1';
          expect("command.load", command.load);
          expect("command.first", command.first, loaded);
          expect("command.step", command.step);
          drawn := fragment.valid = '1';
          expect("fragment.valid", fragment.valid);
          expect("fragment.message", fragment.message, drawn);
          expect("fragment.query", fragment.query, drawn);
          expect("fragment.x", fragment.x, drawn);
          expect("fragment.y", fragment.y, drawn);
          expect("fragment.tail", fragment.tail, drawn);
        end loop;
        close_vectors(vectors, path, "span_walker", count, count);

      elsif run("a_fragment_is_valid_after_the_declared_latency") then
        head_valid  <= '1';
        head.single <= '1';
        go          <= '1';
        wait until rising_edge(clk);
        check_equal(head_taken, '1', "head_taken");
        head_valid  <= '0';
        for clock in 1 to latency loop
          wait until rising_edge(clk);
          check_equal(fragment.valid, to_std_ulogic(clock = latency),
                      "fragment.valid " & to_string(clock) & " clocks after the head was taken");
        end loop;

      elsif run("reset_drops_the_span") then
        head_valid  <= '1';
        head.length <= to_unsigned(9, coordinate_bits);
        go          <= '1';
        wait until rising_edge(clk);
        head_valid  <= '0';
        wait until rising_edge(clk);
        rst         <= '1';
        wait until rising_edge(clk);
        rst         <= '0';
        for clock in 1 to latency + 1 loop
          wait until rising_edge(clk);
          check_equal(fragment.valid, '0', "fragment.valid after reset");
        end loop;
      end if;
    end loop;

    test_runner_cleanup(runner);
  end process;

  dut : entity sheen.span_walker
    port map (
      clk        => clk,
      rst        => rst,
      head_valid => head_valid,
      head       => head,
      head_taken => head_taken,
      go         => go,
      command    => command,
      fragment   => fragment
    );

end architecture;
