-- SPDX-License-Identifier: MIT
--
-- stream_fifo against its kernel: flags, addresses and data in every clock, at full speed and with writer and reader
-- pausing at random.

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

entity tb_stream_fifo is
  generic (
    runner_cfg    : string;
    width         : positive;
    depth_log2    : positive;
    reserve       : natural;
    stall_percent : natural;
    count         : positive;
    seed          : positive;
    vector_folder : string
  );
end entity;

architecture tb of tb_stream_fifo is

  constant latency      : positive := sheen.stream_fifo'latency;
  constant clock_period : time := 10 ns;
  constant generics     : string :=
    "width=" & to_string(width) & ",depth_log2=" & to_string(depth_log2) & ",reserve=" & to_string(reserve) &
    ",stall_percent=" & to_string(stall_percent);
  constant path         : string := vector_path(vector_folder, "stream_fifo", generics);

  signal clk                         : std_ulogic := '0';
  signal rst                         : std_ulogic := '1';
  signal ready, valid, fetch         : std_ulogic;
  signal write_enable, taken         : std_ulogic := '0';
  signal write_data                  : std_ulogic_vector(width - 1 downto 0) := (others => '0');
  signal data                        : std_ulogic_vector(width - 1 downto 0);
  signal write_address, read_address : unsigned(depth_log2 - 1 downto 0);

begin

  clk <= not clk after clock_period / 2;

  main : process
    file vectors          : text;
    variable vector       : line;
    variable bit_word     : std_ulogic;
    variable data_word    : std_ulogic_vector(width - 1 downto 0);
    variable address_word : std_ulogic_vector(depth_log2 - 1 downto 0);

    procedure expect_bit(number : positive; name : string; got : std_ulogic) is
    begin
      read_word(vector, path, number, bit_word);
      check_equal(got, bit_word, path & ":" & to_string(number + 1) & ": " & name);
    end procedure;

    procedure expect_address(number : positive; name : string; got : unsigned) is
    begin
      read_word(vector, path, number, address_word);
      check_equal(got, unsigned(address_word), path & ":" & to_string(number + 1) & ": " & name);
    end procedure;
  begin
    test_runner_setup(runner, runner_cfg);
    wait until rising_edge(clk);
    rst <= '0';

    while test_suite loop
      if run("every_clock_shows_the_kernels_flags_and_data") then
        open_vectors(vectors, path, "stream_fifo", count, seed, generics);
        for number in 1 to count loop
          read_vector(vectors, path, number, vector);
          read_word(vector, path, number, bit_word);
          write_enable <= bit_word;
          read_word(vector, path, number, data_word);
          write_data   <= data_word;
          read_word(vector, path, number, bit_word);
          taken        <= bit_word;
          wait until rising_edge(clk);
          expect_bit(number, "ready", ready);
          expect_bit(number, "valid", valid);
          read_word(vector, path, number, data_word);
          if valid = '1' then
            check_equal(data, data_word, path & ":" & to_string(number + 1) & ": data");
          end if;
          expect_address(number, "write_address", write_address);
          expect_bit(number, "fetch", fetch);
          expect_address(number, "read_address", read_address);
        end loop;
        close_vectors(vectors, path, "stream_fifo", count, count);

      elsif run("a_word_is_valid_after_the_declared_latency") then
        write_enable <= '1';
        write_data   <= (others => '1');
        wait until rising_edge(clk);
        write_enable <= '0';
        for clock in 1 to latency loop
          wait until rising_edge(clk);
          check_equal(valid, to_std_ulogic(clock = latency), "valid " & to_string(clock) & " clocks after the write");
        end loop;
        check_equal(data, write_data, "data");

      elsif run("reset_empties_the_queue") then
        write_enable <= '1';
        for clock in 1 to 2 ** depth_log2 - reserve loop
          wait until rising_edge(clk);
        end loop;
        write_enable <= '0';
        rst          <= '1';
        wait until rising_edge(clk);
        rst          <= '0';
        for clock in 1 to latency + 1 loop
          wait until rising_edge(clk);
          check_equal(valid, '0', "valid after reset");
          check_equal(ready, '1', "ready after reset");
          check_equal(write_address, read_address, "addresses after reset");
        end loop;
      end if;
    end loop;

    test_runner_cleanup(runner);
  end process;

  dut : entity sheen.stream_fifo
    generic map (
      width      => width,
      depth_log2 => depth_log2,
      reserve    => reserve
    )
    port map (
      clk           => clk,
      rst           => rst,
      ready         => ready,
      write         => write_enable,
      write_data    => write_data,
      valid         => valid,
      data          => data,
      taken         => taken,
      write_address => write_address,
      fetch         => fetch,
      read_address  => read_address
    );

end architecture;
