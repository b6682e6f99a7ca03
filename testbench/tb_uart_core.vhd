-- SPDX-License-Identifier: MIT
--
-- uart_core, the core of every board, at the ends of its serial line: bytes of packet files in, and every byte out the
-- kernel's. The host is a line of its own rate; between packets it waits for their answers, as a host must.
--
-- Besides: a line break drops a broken packet and nothing after it, and words that come too fast are told.

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

entity tb_uart_core is
  generic (
    runner_cfg     : string;
    words_per_beat : positive;
    has_depth      : boolean;
    has_quadratic  : boolean;
    rate_percent   : integer;  -- the host's bits are so much longer than the board's
    count          : positive;
    seed           : positive;
    vector_folder  : string
  );
end entity;

architecture tb of tb_uart_core is

  constant clock_period   : time     := 10 ns;
  constant clocks_per_bit : positive := 8;
  constant bit_time       : time     := clocks_per_bit * clock_period;
  constant host_bit_time  : time     := bit_time * (100 + rate_percent) / 100;
  constant patience       : time     := 100000 * clock_period;  -- longest wait for a word
  constant generics       : string   :=
    "words_per_beat=" & to_string(words_per_beat) & ",has_depth=" & to_string(has_depth) & ",has_quadratic="
    & to_string(has_quadratic);
  constant path           : string   := vector_path(vector_folder, "uart_core", generics);

  constant fence : word_t := x"05170000";
  constant echo  : pixel_word_t := fence & x"00000fff";

  type vector_t is record
    sends    : std_ulogic;
    word     : word_t;
    due      : word_t;
    answered : std_ulogic;
    answer   : pixel_word_t;
  end record;

  procedure read_entry(file vectors : text; number : in positive; variable entry : out vector_t) is
    variable vector : line;
  begin
    read_vector(vectors, path, number, vector);
    read_word(vector, path, number, entry.sends);
    read_word(vector, path, number, entry.word);
    read_word(vector, path, number, entry.due);
    read_word(vector, path, number, entry.answered);
    read_word(vector, path, number, entry.answer);
    deallocate(vector);
  end procedure;

  procedure send_word(signal line_out : out std_ulogic; word : in word_t) is
  begin
    for k in 0 to 3 loop
      line_out <= '0';
      wait for host_bit_time;
      for i in 8 * k to 8 * k + 7 loop
        line_out <= word(i);
        wait for host_bit_time;
      end loop;
      line_out <= '1';
      wait for host_bit_time;
    end loop;
  end procedure;

  signal clk         : std_ulogic := '0';
  signal rxd         : std_ulogic := '1';
  signal txd         : std_ulogic;
  signal lost        : std_ulogic;
  signal started     : boolean    := false;
  signal answers     : natural    := 0;
  signal last_answer : pixel_word_t;
  signal compared    : boolean    := false;

begin

  clk <= not clk after clock_period / 2;

  main : process
    file vectors   : text;
    variable entry : vector_t;
    variable sent  : natural := 0;
  begin
    test_runner_setup(runner, runner_cfg);
    wait for 100 * clock_period;

    while test_suite loop
      if run("every_byte_is_the_kernels") then
        started <= true;
        open_vectors(vectors, path, "uart_core", count, seed, generics);
        for number in 1 to count loop
          read_entry(vectors, number, entry);
          if entry.sends = '1' then
            if answers < to_integer(unsigned(entry.due)) then
              wait until answers >= to_integer(unsigned(entry.due)) for patience;
            end if;
            check(
              answers >= to_integer(unsigned(entry.due)), path & ":" & to_string(number + 1) & ": "
              & to_string(answers) & " answers came, of " & to_string(to_integer(unsigned(entry.due))));
            send_word(rxd, entry.word);
          end if;
        end loop;
        file_close(vectors);
        if not compared then
          wait until compared for patience;
        end if;
        check(compared, path & ": every answer came");
        wait for 200 * bit_time;
        check_equal(lost, '0', "lost, though the host waited");

      elsif run("a_line_break_drops_a_broken_packet_and_nothing_after_it") then
        send_word(rxd, x"03000009");
        send_word(rxd, fence);
        rxd <= '0';
        wait for 15 * bit_time;
        rxd <= '1';
        wait for 2 * bit_time;
        send_word(rxd, fence);
        wait until answers = 1 for patience;
        check_equal(answers, 1, "answers after the break");
        check_equal(last_answer, echo, "the echo of the fence after the break");

      elsif run("words_that_come_too_fast_are_told") then
        for k in 1 to 300 loop
          send_word(rxd, fence);
          sent := sent + 1;
          exit when lost = '1';
        end loop;
        check_equal(lost, '1', "lost after " & to_string(sent) & " fences, each answered by twice its bytes");
        check(sent > 32, "the queues hold the first fences; lost after " & to_string(sent));
        rxd <= '0';
        wait for 15 * bit_time;
        rxd <= '1';
        wait for 2 * bit_time;
        check_equal(lost, '0', "lost after a line break");
      end if;
    end loop;

    test_runner_cleanup(runner);
  end process;

  listen : process
    variable word : pixel_word_t;
  begin
    for k in 0 to 7 loop
      wait until falling_edge(txd);
      wait for bit_time / 2;
      check_equal(txd, '0', "start bit");
      for i in 8 * k to 8 * k + 7 loop
        wait for bit_time;
        word(i) := txd;
      end loop;
      wait for bit_time;
      check_equal(txd, '1', "stop bit");
    end loop;
    last_answer <= word;
    answers     <= answers + 1;
  end process;

  compare : process
    file vectors   : text;
    variable entry : vector_t;
  begin
    wait until started;
    open_vectors(vectors, path, "uart_core", count, seed, generics);
    for number in 1 to count loop
      read_entry(vectors, number, entry);
      if entry.answered = '1' then
        wait until answers'event;
        check_equal(last_answer, entry.answer, path & ":" & to_string(number + 1) & ": eight bytes of the answer");
      end if;
    end loop;
    close_vectors(vectors, path, "uart_core", count, count);
    compared <= true;
    wait until answers'event;
    check(false, path & ": a word after the last answer");
  end process;

  dut : entity sheen.uart_core
    generic map (
      clocks_per_bit => clocks_per_bit,
      words_per_beat => words_per_beat,
      has_depth      => has_depth,
      has_quadratic  => has_quadratic
    )
    port map (
      clk          => clk,
      rxd          => rxd,
      txd          => txd,
      receiving    => open,
      transmitting => open,
      lost         => lost,
      alive        => open
    );

end architecture;
