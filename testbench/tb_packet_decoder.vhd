-- SPDX-License-Identifier: MIT
--
-- packet_decoder against its kernel, clock by clock: a vector holds one clock's inputs and the outputs that stand
-- in it.
--
-- beat_ready and job.valid are compared in every clock, the job while job.valid is set: a triangle's flags, or a
-- message's code and header. A triangle's geometry is compared in the clocks of its job, all words in the clock after
-- each, when the channels load them. stall_percent is a property of the vectors: the share of clocks without a beat,
-- and of those that leave a job untaken.

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

entity tb_packet_decoder is
  generic (
    runner_cfg     : string;
    words_per_beat : positive;
    has_depth      : boolean;
    has_quadratic  : boolean;
    log_channels   : natural;
    has_power      : boolean;
    stall_percent  : natural;
    count          : positive;
    seed           : positive;
    vector_folder  : string
  );
end entity;

architecture tb of tb_packet_decoder is

  constant latency        : positive := sheen.packet_decoder'latency;
  constant clock_period   : time := 10 ns;
  constant register_count : positive :=
    geometry_words + phase_words
    + (colour_channels + log_channels) * choose(has_quadratic, quadratic_words, linear_words)
    + choose(has_depth, linear_words, 0);
  constant generics : string :=
    "words_per_beat=" & to_string(words_per_beat) & ",has_depth=" & to_string(has_depth) & ",has_quadratic="
    & to_string(has_quadratic) & ",log_channels=" & to_string(log_channels) & ",has_power=" & to_string(has_power)
    & ",stall_percent=" & to_string(stall_percent);
  constant path : string := vector_path(vector_folder, "packet_decoder", generics);

  signal clk        : std_ulogic := '0';
  signal rst        : std_ulogic := '1';
  signal beat_valid : std_ulogic := '0';
  signal beat_ready : std_ulogic;
  signal beat_words : word_vector_t(0 to words_per_beat - 1) := (others => (others => '0'));
  signal beat_keep  : std_ulogic_vector(words_per_beat - 1 downto 0) := (others => '0');
  signal beat_last  : std_ulogic := '0';
  signal job        : job_t;
  signal job_taken  : std_ulogic := '0';
  signal words      : word_vector_t(0 to register_count - 1);

  signal material         : material_t;
  signal table_write      : table_write_t;
  signal material_applied : std_ulogic := '0';
  signal table_applied    : std_ulogic := '0';

begin

  clk <= not clk after clock_period / 2;

  main : process
    file vectors    : text;
    variable vector : line;
    variable number : positive := 1;

    variable triangle_before : boolean := false;  -- the clock before had a triangle's job
    variable material_known  : boolean := false;  -- a material has come

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

    procedure drive is
    begin
      beat_valid <= next_bit;
      beat_last  <= next_bit;
      beat_keep  <= next_word(words_per_beat);
      for lane in beat_words'range loop
        beat_words(lane) <= next_word(word_t'length);
      end loop;
      job_taken        <= next_bit;
      material_applied <= next_bit;
      table_applied    <= next_bit;
    end procedure;

    procedure compare(got, expected : std_ulogic; name : string) is
    begin
      check_equal(got, expected, path & ":" & to_string(number + 1) & ": " & name);
    end procedure;

    procedure compare(got, expected : std_ulogic_vector; name : string) is
    begin
      check_equal(got, expected, path & ":" & to_string(number + 1) & ": " & name);
    end procedure;

    -- Every word is read, and compared only when it means something.
    procedure compare_outputs is
      variable expected   : job_t;
      variable word       : word_t;
      variable a_triangle : boolean;
      variable a_material : material_t;
      variable a_write    : table_write_t;
    begin
      compare(beat_ready, next_bit, "beat_ready");
      expected.valid    := next_bit;
      expected.message  := next_bit;
      expected.leftward := next_bit;
      expected.linear   := next_bit;
      expected.depth    := next_bit;
      expected.log      := next_word(2);
      expected.code     := next_word(2);
      expected.header   := next_word(word_t'length);
      compare(job.valid, expected.valid, "job.valid");
      a_triangle := expected.valid = '1' and expected.message = '0';
      if expected.valid = '1' then
        compare(job.message, expected.message, "job.message");
      end if;
      if a_triangle then
        compare(job.leftward, expected.leftward, "job.leftward");
        compare(job.linear, expected.linear, "job.linear");
        compare(job.depth, expected.depth, "job.depth");
        compare(job.log, expected.log, "job.log");
      elsif expected.valid = '1' then
        compare(job.code, expected.code, "job.code");
        compare(job.header, expected.header, "job.header");
      end if;
      a_material.red   := unsigned(next_word(ambient_t'length));
      a_material.green := unsigned(next_word(ambient_t'length));
      a_material.blue  := unsigned(next_word(ambient_t'length));
      a_material.power := next_word(max_log_channels);
      if expected.valid = '1' and expected.message = '1' and expected.code = "00"
        and unsigned(expected.header(31 downto 24)) = opcode_material then
        material_known := true;
      end if;
      if material_known then
        compare(std_ulogic_vector(material.red), std_ulogic_vector(a_material.red), "material.red");
        compare(std_ulogic_vector(material.green), std_ulogic_vector(a_material.green), "material.green");
        compare(std_ulogic_vector(material.blue), std_ulogic_vector(a_material.blue), "material.blue");
        compare(material.power, a_material.power, "material.power");
      end if;
      a_write.valid   := next_bit;
      a_write.bank    := next_bit;
      a_write.address := unsigned(next_word(power_word_bits));
      a_write.data    := next_word(word_t'length);
      compare(table_write.valid, a_write.valid, "table_write.valid");
      if a_write.valid = '1' then
        compare(table_write.bank, a_write.bank, "table_write.bank");
        compare(std_ulogic_vector(table_write.address), std_ulogic_vector(a_write.address), "table_write.address");
        compare(table_write.data, a_write.data, "table_write.data");
      end if;
      for r in words'range loop
        word := next_word(word_t'length);
        if triangle_before or (a_triangle and r < geometry_words + phase_words) then
          compare(words(r), word, "words(" & to_string(r) & ")");
        end if;
      end loop;
      triangle_before := a_triangle;
    end procedure;
  begin
    test_runner_setup(runner, runner_cfg);
    check_equal(latency, 1, "the vectors hold the outputs of the clock after the last beat");
    wait until rising_edge(clk);
    rst <= '0';

    while test_suite loop
      if run("every_clock_has_the_kernels_outputs") then
        open_vectors(vectors, path, "packet_decoder", count, seed, generics);
        for k in 1 to count loop
          number := k;
          read_vector(vectors, path, number, vector);
          drive;
          wait until rising_edge(clk);
          compare_outputs;
        end loop;
        close_vectors(vectors, path, "packet_decoder", count, number);

      elsif run("reset_drops_the_packet_under_way") then
        beat_words(0) <= x"ff000000";  -- an unknown opcode, and its packet goes on
        beat_keep     <= (others => '1');
        beat_valid    <= '1';
        wait until rising_edge(clk);
        wait until rising_edge(clk);
        beat_valid <= '0';
        rst        <= '1';
        wait until rising_edge(clk);
        rst           <= '0';
        beat_words(0) <= x"05070000";
        beat_keep     <= (0 => '1', others => '0');
        beat_last     <= '1';
        beat_valid    <= '1';
        wait until rising_edge(clk);
        check_equal(job.valid, '0', "a message after reset");
        check_equal(beat_ready, '1', "beat_ready after reset");
        beat_valid <= '0';
        wait until rising_edge(clk) and job.valid = '1' for 10 * clock_period;
        check_equal(job.valid, '1', "job.valid for the fence after reset");
        check_equal(job.header, std_ulogic_vector'(x"05070000"), "the fence after reset");
        check_equal(job.code, std_ulogic_vector'("00"), "the code of the fence after reset");
      end if;
    end loop;

    test_runner_cleanup(runner);
  end process;

  dut : entity sheen.packet_decoder
    generic map (
      words_per_beat => words_per_beat,
      has_depth      => has_depth,
      has_quadratic  => has_quadratic,
      log_channels   => log_channels,
      has_power      => has_power,
      register_count => register_count
    )
    port map (
      clk        => clk,
      rst        => rst,
      beat_valid => beat_valid,
      beat_ready => beat_ready,
      beat_words => beat_words,
      beat_keep  => beat_keep,
      beat_last  => beat_last,
      job        => job,
      job_taken  => job_taken,
      words      => words,
      material         => material,
      table_write      => table_write,
      material_applied => material_applied,
      table_applied    => table_applied
    );

end architecture;
