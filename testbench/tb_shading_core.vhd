-- SPDX-License-Identifier: MIT
--
-- shading_core against its kernel: whole packets in, every word out, at full speed and with pauses on both streams.
--
-- Vector k holds beat k of the setup stream and word k of the answer, each with a bit that says whether there is one.
-- The bench drives on falling edges and samples on rising ones, so an output that changes at any other time than after
-- a rising edge hangs on an input. AXI4-Stream: a valid word stays until it is taken; valid waits for no ready; tlast
-- is set on the echo of a fence and on nothing else.

library ieee;
use ieee.math_real.all;
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

entity tb_shading_core is
  generic (
    runner_cfg     : string;
    words_per_beat : positive;
    has_depth      : boolean;
    has_quadratic  : boolean;
    log_channels   : natural;
    has_power      : boolean;
    slices         : positive;
    stall_percent  : natural;
    count          : positive;
    seed           : positive;
    vector_folder  : string
  );
end entity;

architecture tb of tb_shading_core is

  constant clock_period : time := 10 ns;
  constant patience     : time := 10000 * clock_period;  -- longest wait for a word or for tready
  constant generics     : string :=
    "words_per_beat=" & to_string(words_per_beat) & ",has_depth=" & to_string(has_depth) & ",has_quadratic="
    & to_string(has_quadratic) & ",log_channels=" & to_string(log_channels) & ",has_power=" & to_string(has_power);
  constant path : string := vector_path(vector_folder, "shading_core", generics);

  type beat_t is record
    present : std_ulogic;
    last    : std_ulogic;
    keep    : std_ulogic_vector(words_per_beat - 1 downto 0);
    data    : std_ulogic_vector(32 * words_per_beat - 1 downto 0);
  end record;
  type answer_t is record
    present : std_ulogic;
    word    : pixel_word_t;
  end record;

  procedure read_entries(
    file vectors    : text;
    number          : in positive;
    variable beat   : out beat_t;
    variable answer : out answer_t
  ) is
    variable vector : line;
  begin
    read_vector(vectors, path, number, vector);
    read_word(vector, path, number, beat.present);
    read_word(vector, path, number, beat.last);
    read_word(vector, path, number, beat.keep);
    for lane in 0 to words_per_beat - 1 loop
      read_word(vector, path, number, beat.data(32 * lane + 31 downto 32 * lane));
    end loop;
    read_word(vector, path, number, answer.present);
    read_word(vector, path, number, answer.word);
    deallocate(vector);
  end procedure;

  -- Shares of clocks without a beat and without tready, in percent; or tready waits for tvalid.
  type pauses_t is record
    source           : natural;
    sink             : natural;
    waits_for_tvalid : boolean;
  end record;
  type pauses_vector_t is array (natural range <>) of pauses_t;
  constant pauses_in_turn : pauses_vector_t := (
    (stall_percent, stall_percent, false),
    (stall_percent, stall_percent, true),
    (0, 50 + stall_percent / 2, false),
    (50 + stall_percent / 2, 0, false)
  );
  signal pauses : pauses_t := (0, 0, false);

  signal clk           : std_ulogic := '0';
  signal rst           : std_ulogic := '1';
  signal started       : boolean    := false;
  signal sent          : boolean    := false;
  signal all_compared  : boolean    := false;
  signal s_axis_tdata  : std_ulogic_vector(32 * words_per_beat - 1 downto 0) := (others => '0');
  signal s_axis_tkeep  : std_ulogic_vector(4 * words_per_beat - 1 downto 0)  := (others => '0');
  signal s_axis_tlast  : std_ulogic := '0';
  signal s_axis_tvalid : std_ulogic := '0';
  signal s_axis_tready : std_ulogic;
  signal m_axis_tdata  : std_ulogic_vector(pixel_bits - 1 downto 0);
  signal m_axis_tlast  : std_ulogic;
  signal m_axis_tvalid : std_ulogic;
  signal m_axis_tready : std_ulogic := '0';

begin

  clk <= not clk after clock_period / 2;

  main : process
  begin
    test_runner_setup(runner, runner_cfg);
    wait until rising_edge(clk);
    wait until rising_edge(clk);
    rst <= '0';

    while test_suite loop
      if run("every_word_is_the_kernels") then
        started <= true;
        if stall_percent > 0 then
          while not (sent and all_compared) loop
            for k in pauses_in_turn'range loop
              pauses <= pauses_in_turn(k);
              wait until sent and all_compared for 500 * clock_period;
            end loop;
          end loop;
        end if;
        wait until rising_edge(clk) and sent and all_compared;
        wait for 100 * clock_period;
      end if;
    end loop;

    test_runner_cleanup(runner);
  end process;

  source : process
    file vectors          : text;
    variable beat         : beat_t;
    variable answer       : answer_t;
    variable seed1, seed2 : positive := seed;
    variable random       : real;
  begin
    wait until started;
    open_vectors(vectors, path, "shading_core", count, seed, generics);
    for number in 1 to count loop
      read_entries(vectors, number, beat, answer);
      next when beat.present = '0';
      loop
        wait until falling_edge(clk);
        uniform(seed1, seed2, random);
        exit when random * 100.0 >= real(pauses.source);
        s_axis_tvalid <= '0';
        s_axis_tdata  <= not s_axis_tdata;  -- noise, which must change nothing
        s_axis_tlast  <= '1';
      end loop;
      s_axis_tvalid <= '1';
      s_axis_tdata  <= beat.data;
      s_axis_tlast  <= beat.last;
      for lane in 0 to words_per_beat - 1 loop
        s_axis_tkeep(4 * lane + 3 downto 4 * lane) <= (others => beat.keep(lane));
      end loop;
      wait until rising_edge(clk) and s_axis_tready = '1' for patience;
      check_equal(s_axis_tready, '1', path & ":" & to_string(number + 1) & ": s_axis_tready");
    end loop;
    wait until falling_edge(clk);
    s_axis_tvalid <= '0';
    file_close(vectors);
    sent <= true;
    wait;
  end process;

  offer_ready : process
    variable seed1  : positive := seed;
    variable seed2  : positive := 7919;
    variable random : real;
  begin
    wait until falling_edge(clk);
    uniform(seed1, seed2, random);
    m_axis_tready <= '1' when random * 100.0 >= real(pauses.sink) else '0';
    if pauses.waits_for_tvalid and m_axis_tvalid /= '1' then
      m_axis_tready <= '0';
    end if;
  end process;

  sink : process
    file vectors     : text;
    variable beat    : beat_t;
    variable answer  : answer_t;
    variable read_up : natural := 0;
  begin
    wait until started;
    open_vectors(vectors, path, "shading_core", count, seed, generics);
    for number in 1 to count loop
      read_entries(vectors, number, beat, answer);
      if answer.present = '1' then
        wait until rising_edge(clk) and m_axis_tvalid = '1' and m_axis_tready = '1' for patience;
        check_equal(m_axis_tvalid and m_axis_tready, '1', path & ":" & to_string(number + 1) & ": a word in time");
        check_equal(m_axis_tdata, answer.word, path & ":" & to_string(number + 1) & ": m_axis_tdata");
        check_equal(
          m_axis_tlast, to_std_ulogic(unsigned(answer.word(23 downto 0)) = message_x),
          path & ":" & to_string(number + 1) & ": m_axis_tlast, set on the echo of a fence");
      end if;
      read_up := number;
    end loop;
    close_vectors(vectors, path, "shading_core", count, read_up);
    all_compared <= true;
    loop
      wait until rising_edge(clk);
      check_equal(m_axis_tvalid, '0', path & ": m_axis_tvalid after the last word");
    end loop;
  end process;

  axi_rules : process (clk)
    variable before : pixel_word_t;
    variable last   : std_ulogic;
    variable waits  : boolean := false;
  begin
    if rising_edge(clk) then
      if waits then
        check_equal(m_axis_tvalid, '1', "m_axis_tvalid fell before its word was taken");
        check_equal(m_axis_tdata, before, "m_axis_tdata changed before it was taken");
        check_equal(m_axis_tlast, last, "m_axis_tlast changed before it was taken");
      end if;
      before := m_axis_tdata;
      last   := m_axis_tlast;
      waits  := m_axis_tvalid = '1' and m_axis_tready = '0' and rst = '0';
    end if;
  end process;

  no_combinational_path : process (m_axis_tvalid, m_axis_tdata, m_axis_tlast, s_axis_tready)
  begin
    if now > 0 ns then
      check(clk = '1' and clk'last_event = 0 ns, "an output changed other than with the rising edge of clk");
    end if;
  end process;

  dut : entity sheen.shading_core
    generic map (
      words_per_beat => words_per_beat,
      has_depth      => has_depth,
      has_quadratic  => has_quadratic,
      log_channels   => log_channels,
      has_power      => has_power,
      slices         => slices
    )
    port map (
      clk           => clk,
      rst           => rst,
      s_axis_tdata  => s_axis_tdata,
      s_axis_tkeep  => s_axis_tkeep,
      s_axis_tlast  => s_axis_tlast,
      s_axis_tvalid => s_axis_tvalid,
      s_axis_tready => s_axis_tready,
      m_axis_tdata  => m_axis_tdata,
      m_axis_tlast  => m_axis_tlast,
      m_axis_tvalid => m_axis_tvalid,
      m_axis_tready => m_axis_tready
    );

end architecture;
