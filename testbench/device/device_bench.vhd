-- SPDX-License-Identifier: MIT
--
-- device_bench: the core as a device of the host library. Plays a file of beats into the setup stream, writes the words
-- that come out, and ends with the echo of the last fence.
--
-- beat_file: one line a beat, "last count words", words of the whole beat in hexadecimal, the highest word first.
-- word_file: the clock cycles from the first beat to the last word before the last echo, then one word a line.
-- source_percent, sink_percent: share of clocks in which no beat is offered and no word taken.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;
  use ieee.math_real.all;

library std;
  use std.textio.all;
  use std.env.all;

library sheen;
  use sheen.sheen_constants_pkg.all;

entity device_bench is
  generic (
    beat_file      : string   := "";
    word_file      : string   := "";
    fences         : positive := 1;
    source_percent : natural  := 0;
    sink_percent   : natural  := 0;
    seed           : positive := 1;
    words_per_beat : positive := 2;
    has_depth      : boolean  := true;
    has_quadratic  : boolean  := true;
    log_channels   : natural  := 3;
    has_power      : boolean  := true;
    slices         : positive := 2
  );
end entity device_bench;

architecture bench of device_bench is

  constant idle_limit : positive := 1_000_000;  -- clocks without a beat or a word

  signal clk           : std_ulogic := '0';
  signal rst           : std_ulogic := '1';
  signal s_axis_tdata  : std_ulogic_vector(32 * words_per_beat - 1 downto 0);
  signal s_axis_tkeep  : std_ulogic_vector(4 * words_per_beat - 1 downto 0);
  signal s_axis_tlast  : std_ulogic;
  signal s_axis_tvalid : std_ulogic := '0';
  signal s_axis_tready : std_ulogic;
  signal m_axis_tdata  : std_ulogic_vector(pixel_bits - 1 downto 0);
  signal m_axis_tlast  : std_ulogic;
  signal m_axis_tvalid : std_ulogic;
  signal m_axis_tready : std_ulogic := '0';

  signal first_cycle : natural := 0;
  signal cycle       : natural := 0;

begin

  clk   <= not clk after 1 ns;
  rst   <= '0' after 6 ns;
  cycle <= cycle + 1 when rising_edge(clk);

  core : entity sheen.shading_core
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

  source : process is
    file beats         : text;
    variable status    : file_open_status;
    variable l         : line;
    variable last      : natural;
    variable count     : natural;
    variable data      : std_ulogic_vector(s_axis_tdata'range);
    variable good      : boolean;
    variable seed_1    : positive := seed;
    variable seed_2    : positive := 7919;
    variable chance    : real;
    variable any       : boolean := false;
  begin
    file_open(status, beats, beat_file, read_mode);
    assert status = open_ok
      report "can't read the beats in '" & beat_file & "'"
      severity failure;
    wait until rst = '0' and rising_edge(clk);
    while not endfile(beats) loop
      readline(beats, l);
      read(l, last, good);
      assert good
        report "'" & beat_file & "': a line doesn't start with 0 or 1"
        severity failure;
      read(l, count);
      hread(l, data);
      if source_percent > 0 then
        loop
          uniform(seed_1, seed_2, chance);
          exit when chance * 100.0 >= real(source_percent);
          s_axis_tvalid <= '0';
          wait until rising_edge(clk);
        end loop;
      end if;
      s_axis_tdata <= data;
      s_axis_tlast <= '1' when last = 1 else '0';
      for k in 0 to words_per_beat - 1 loop
        s_axis_tkeep(4 * k + 3 downto 4 * k) <= "1111" when k < count else "0000";
      end loop;
      s_axis_tvalid <= '1';
      if not any then
        first_cycle <= cycle;
        any         := true;
      end if;
      wait until rising_edge(clk) and s_axis_tready = '1';
    end loop;
    s_axis_tvalid <= '0';
    wait;
  end process source;

  -- The words are kept in a file of their own until the number of cycles, which stands first, is known.
  sink : process is
    file words            : text;
    file body_file        : text;
    variable status       : file_open_status;
    variable l            : line;
    variable echoes       : natural  := 0;
    variable last_cycle   : natural  := 0;
    variable before_last  : natural  := 0;
    variable busy_cycle   : natural  := 0;
    variable seed_1       : positive := seed;
    variable seed_2       : positive := 104729;
    variable chance       : real;
  begin
    file_open(status, body_file, word_file & ".body", write_mode);
    assert status = open_ok
      report "can't write the words to '" & word_file & ".body'"
      severity failure;
    while echoes < fences loop
      chance := 1.0;
      if sink_percent > 0 then
        uniform(seed_1, seed_2, chance);
      end if;
      m_axis_tready <= '1' when chance * 100.0 >= real(sink_percent) else '0';
      wait until rising_edge(clk);
      if s_axis_tvalid = '1' and s_axis_tready = '1' then
        busy_cycle := cycle;
      end if;
      if m_axis_tvalid = '1' and m_axis_tready = '1' then
        busy_cycle  := cycle;
        before_last := last_cycle;
        last_cycle  := cycle;
        hwrite(l, m_axis_tdata);
        writeline(body_file, l);
        if m_axis_tlast = '1' then
          echoes := echoes + 1;
        end if;
      end if;
      assert cycle - busy_cycle < idle_limit
        report "no beat was taken and no word came for " & integer'image(idle_limit) & " clocks"
        severity failure;
    end loop;
    file_close(body_file);

    file_open(body_file, word_file & ".body", read_mode);
    file_open(words, word_file, write_mode);
    if before_last > first_cycle then
      write(l, before_last - first_cycle);
    else
      write(l, 0);
    end if;
    writeline(words, l);
    while not endfile(body_file) loop
      readline(body_file, l);
      writeline(words, l);
    end loop;
    file_close(words);
    stop(0);
    wait;
  end process sink;

end architecture bench;
