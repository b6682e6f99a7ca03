-- SPDX-License-Identifier: MIT
--
-- highlight_stage against its kernel: in every clock what the decoder is told and whether a word leaves, and with it
-- fragment, colours and depth; fragments without a gap and with random pauses, in which all else is noise.

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

entity tb_highlight_stage is
  generic (
    runner_cfg    : string;
    log_channels  : positive;
    has_power     : boolean;
    stall_percent : natural;
    count         : positive;
    seed          : positive;
    vector_folder : string
  );
end entity;

architecture tb of tb_highlight_stage is

  constant latency      : positive := highlight_latency + log_channels;
  constant clock_period : time := 10 ns;
  constant generics     : string :=
    "log_channels=" & to_string(log_channels) & ",has_power=" & to_string(has_power) & ",stall_percent=" &
    to_string(stall_percent);
  constant path         : string := vector_path(vector_folder, "highlight_stage", generics);
  constant no_fragment  : fragment_t := (
    log => "00", x => (others => '0'), y => (others => '0'), tail => (others => '0'), others => '0');
  constant tail_of_material : coordinate_t := to_unsigned(opcode_material * 16, coordinate_bits);

  subtype colour_t is std_ulogic_vector(colour_integer_bits - 1 downto 0);
  subtype depth_t is std_ulogic_vector(depth_bits - 1 downto 0);

  signal clk                           : std_ulogic := '0';
  signal rst                           : std_ulogic := '1';
  signal fragment                      : fragment_t := no_fragment;
  signal red, green, blue              : diffuse_t := (others => '0');
  signal depth                         : depth_t := (others => '0');
  signal logs                          : log_vector_t(0 to log_channels - 1) := (others => (others => '0'));
  signal pending                       : material_t := no_material;
  signal table_write                   : table_write_t := no_table_write;
  signal material_applied              : std_ulogic;
  signal table_applied                 : std_ulogic;
  signal fragment_out                  : fragment_t;
  signal red_out, green_out, blue_out  : colour_t;
  signal depth_out                     : depth_t;

begin

  clk <= not clk after clock_period / 2;

  main : process
    file vectors    : text;
    variable vector : line;
    variable number : positive;

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
      read.log     := next_bits(flag_log_channels_bits);
      read.x       := unsigned(next_bits(coordinate_bits));
      read.y       := unsigned(next_bits(coordinate_bits));
      read.tail    := unsigned(next_bits(coordinate_bits));
      return read;
    end function;

    procedure drive_vector is
    begin
      fragment <= next_fragment;
      red      <= next_bits(diffuse_t'length);
      green    <= next_bits(diffuse_t'length);
      blue     <= next_bits(diffuse_t'length);
      depth    <= next_bits(depth_bits);
      for k in logs'range loop
        logs(k) <= signed(next_bits(log_t'length));
      end loop;
      pending.red         <= unsigned(next_bits(ambient_t'length));
      pending.green       <= unsigned(next_bits(ambient_t'length));
      pending.blue        <= unsigned(next_bits(ambient_t'length));
      pending.power       <= next_bits(max_log_channels);
      table_write.valid   <= next_bit;
      table_write.bank    <= next_bit;
      table_write.address <= unsigned(next_bits(power_word_bits));
      table_write.data    <= next_bits(word_bits);
    end procedure;

    procedure expect(name : string; got, expected : std_ulogic_vector) is
    begin
      check_equal(got, expected, path & ":" & to_string(number + 1) & ": " & name);
    end procedure;

    -- Of a fragment that is not valid the rest is not looked at.
    procedure expect_outputs is
      variable expected_material : std_ulogic_vector(0 to 0);
      variable expected_table    : std_ulogic_vector(0 to 0);
      variable expected          : fragment_t;
      variable expected_red      : colour_t;
      variable expected_green    : colour_t;
      variable expected_blue     : colour_t;
      variable expected_depth    : depth_t;
    begin
      expected_material(0) := next_bit;
      expected_table(0)    := next_bit;
      expected             := next_fragment;
      expected_red         := next_bits(colour_integer_bits);
      expected_green       := next_bits(colour_integer_bits);
      expected_blue        := next_bits(colour_integer_bits);
      expected_depth       := next_bits(depth_bits);
      expect("material_applied", (0 => material_applied), expected_material);
      expect("table_applied", (0 => table_applied), expected_table);
      expect("valid", (0 => fragment_out.valid), (0 => expected.valid));
      if fragment_out.valid = '1' then
        expect("message, query, log", fragment_out.message & fragment_out.query & fragment_out.log,
               expected.message & expected.query & expected.log);
        expect("x", std_ulogic_vector(fragment_out.x), std_ulogic_vector(expected.x));
        expect("y", std_ulogic_vector(fragment_out.y), std_ulogic_vector(expected.y));
        expect("tail", std_ulogic_vector(fragment_out.tail), std_ulogic_vector(expected.tail));
        expect("red", red_out, expected_red);
        expect("green", green_out, expected_green);
        expect("blue", blue_out, expected_blue);
        expect("depth", depth_out, expected_depth);
      end if;
    end procedure;
  begin
    test_runner_setup(runner, runner_cfg);
    for clock in 1 to 2 loop
      wait until rising_edge(clk);
    end loop;
    rst <= '0';
    wait until rising_edge(clk);

    while test_suite loop
      if run("every_clock_shows_the_kernels_outputs") then
        open_vectors(vectors, path, "highlight_stage", count, seed, generics);
        for vector_number in 1 to count loop
          number := vector_number;
          read_vector(vectors, path, number, vector);
          drive_vector;
          wait until rising_edge(clk);
          expect_outputs;
        end loop;
        close_vectors(vectors, path, "highlight_stage", count, count);

      elsif run("a_fragment_leaves_after_the_declared_latency") then
        fragment.valid <= '1';
        wait until rising_edge(clk);
        fragment.valid <= '0';
        for clock in 1 to latency + 1 loop
          wait until rising_edge(clk);
          check_equal(fragment_out.valid, to_std_ulogic(clock = latency),
                      "valid " & to_string(clock) & " clocks after the fragment");
        end loop;

      elsif run("reset_empties_the_pipeline_and_forgets_the_material") then
        fragment         <= no_fragment;
        fragment.valid   <= '1';
        fragment.message <= '1';
        fragment.tail    <= tail_of_material;
        pending.red      <= (others => '1');
        wait until rising_edge(clk);
        fragment.message <= '0';
        for clock in 1 to latency loop
          wait until rising_edge(clk);
        end loop;
        rst            <= '1';
        fragment.valid <= '0';
        wait until rising_edge(clk);
        rst            <= '0';
        for clock in 1 to latency + 1 loop
          wait until rising_edge(clk);
          check_equal(fragment_out.valid, '0', "valid after reset");
        end loop;
        -- A highlight of z = 127 is 0, so what is left is ambient.
        logs           <= (others => (log_t'high => '0', others => '1'));
        fragment.valid <= '1';
        fragment.log   <= "01";
        for clock in 0 to latency loop
          wait until rising_edge(clk);
        end loop;
        check_equal(fragment_out.valid, '1', "valid again");
        check_equal(red_out, colour_t'(others => '0'), "ambient after reset");
      end if;
    end loop;

    test_runner_cleanup(runner);
  end process;

  dut : entity sheen.highlight_stage
    generic map (
      log_channels => log_channels,
      has_power    => has_power
    )
    port map (
      clk              => clk,
      rst              => rst,
      fragment         => fragment,
      red              => red,
      green            => green,
      blue             => blue,
      depth            => depth,
      logs             => logs,
      pending          => pending,
      write            => table_write,
      material_applied => material_applied,
      table_applied    => table_applied,
      fragment_out     => fragment_out,
      red_out          => red_out,
      green_out        => green_out,
      blue_out         => blue_out,
      depth_out        => depth_out
    );

end architecture;
