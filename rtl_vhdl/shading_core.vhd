-- SPDX-License-Identifier: MIT
--
-- shading_core: setup packets in, pixels out, both as AXI4-Stream.
--
--   s_axis -> beat queue -> packet_decoder -> edge_walker -> span queue -> span_walker -> colour_stage -> m_axis
--                                 |                                                          ^   (pixel queue)
--                                 +-- words -> forward_difference, one a channel ------------+
--
-- A core with log channels has a highlight_stage before its colour_stage; materials go there from the decoder.
--
-- Three triangles are in work at once: one arrives in the decoder, one is walked along its edges, one is drawn span by
-- span. No clock enable runs through the datapath: when the pixel queue fills, a registered `go` stops the span
-- walker, and what is under way finds room in the queue's reserve.
--
-- Streams: word k of a beat is bits 32k+31..32k; tkeep marks the words of a packet's last beat, tlast stands on it.
-- m_axis_tlast is 1 on a fence echo only. Reset: synchronous, active high.
--
-- Number formats: colour s10.22, depth u16.16, coordinates u12.0, phases u0.32 (sheen_constants_pkg).
-- Latency: about 20 clocks from a packet's last beat to its first pixel; the order of words never depends on stalls.
-- Model: hls/include/sheen/hls/shading_core.hpp.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library sheen;
  use sheen.sheen_constants_pkg.all;
  use sheen.sheen_pkg.all;

entity shading_core is
  generic (
    words_per_beat : positive := 2;          -- setup stream: 1, 2 or 4 words a beat
    has_depth      : boolean  := true;       -- a linear depth channel
    has_quadratic  : boolean  := true;       -- second-order colour channels; without: flat and gouraud only
    colour_width   : positive := word_bits;  -- 10 bits of it integer
    depth_width    : positive := word_bits;  -- 16 bits of it integer
    log_channels   : natural  := 0;          -- 0 to 3, each a highlight; they need has_quadratic
    has_power      : boolean  := false;      -- each log channel has a loadable power table, too
    slices         : positive := 2;          -- each accumulator is cut into so many, one clock apart
    family         : string   := "plain"     -- accumulators for any FPGA, or for "ecp5"
  );
  port (
    clk : in std_ulogic;
    rst : in std_ulogic;

    s_axis_tdata  : in std_ulogic_vector(32 * words_per_beat - 1 downto 0);
    s_axis_tkeep  : in std_ulogic_vector(4 * words_per_beat - 1 downto 0);
    s_axis_tlast  : in std_ulogic;
    s_axis_tvalid : in std_ulogic;
    s_axis_tready : out std_ulogic;

    m_axis_tdata  : out std_ulogic_vector(pixel_bits - 1 downto 0);
    m_axis_tlast  : out std_ulogic;
    m_axis_tvalid : out std_ulogic;
    m_axis_tready : in std_ulogic
  );
end entity shading_core;

architecture rtl of shading_core is

  constant channel_base   : positive := geometry_words + phase_words;
  constant channel_words  : positive := choose(has_quadratic, quadratic_words, linear_words);
  constant depth_base     : positive := channel_base + (colour_channels + log_channels) * channel_words;
  constant register_count : positive := choose(has_depth, depth_base + linear_words, depth_base);

  -- What the core says of itself: the data of the reply to a query.
  signal description : word_vector_t(0 to query_reply_words - 1);

  -- Setup stream.
  constant beat_width : positive := 33 * words_per_beat + 1;
  signal beat_in      : std_ulogic_vector(beat_width - 1 downto 0);
  signal beat         : std_ulogic_vector(beat_width - 1 downto 0);
  signal beat_words   : word_vector_t(0 to words_per_beat - 1);
  signal beat_keep    : std_ulogic_vector(words_per_beat - 1 downto 0);
  signal beat_last    : std_ulogic;
  signal beat_valid   : std_ulogic;
  signal beat_ready   : std_ulogic;

  -- Jobs and their words.
  signal job       : job_t;
  signal job_taken : std_ulogic;
  signal geometry  : geometry_t;
  signal words     : word_vector_t(0 to register_count - 1);

  -- Span queue.
  signal room               : std_ulogic;
  signal push               : std_ulogic;
  signal span               : span_t;
  signal span_vector        : std_ulogic_vector(span_width - 1 downto 0);
  signal head               : span_t;
  signal head_vector        : std_ulogic_vector(span_width - 1 downto 0);
  signal head_valid         : std_ulogic;
  signal head_taken         : std_ulogic;
  signal first_taken        : std_ulogic;
  signal push_address       : span_address_t;
  signal fetch              : std_ulogic;
  signal fetch_address      : span_address_t;
  signal fetch_late         : std_ulogic := '0';
  signal fetch_address_late : span_address_t;

  -- Channels.
  signal edge_part : edge_command_t;
  signal span_part : span_command_t;
  signal command   : channel_command_t;

  -- The highlight stage wants fraction bits, too.
  constant colour_bits : positive := choose(log_channels > 0, diffuse_t'length, colour_integer_bits);
  type value_vector_t is array (0 to colour_channels - 1) of std_ulogic_vector(colour_bits - 1 downto 0);
  signal colour : value_vector_t;                                                 -- s10.0 or s10.4
  signal depth  : std_ulogic_vector(depth_bits - 1 downto 0) := (others => '0');  -- u16.0

  type fragment_vector_t is array (natural range <>) of fragment_t;
  signal fragments       : fragment_vector_t(0 to slices);
  signal walker_fragment : fragment_t;

  -- What the colour stage makes a pixel of: the channels' values, or the highlight stage's.
  signal lit_fragment : fragment_t;
  type colour_vector_t is array (0 to colour_channels - 1) of std_ulogic_vector(colour_integer_bits - 1 downto 0);
  signal lit_colour : colour_vector_t;                                           -- s10.0
  signal lit_depth    : std_ulogic_vector(depth_bits - 1 downto 0);                -- u16.0

  -- Between decoder and highlight stage.
  signal material         : material_t;
  signal table_write      : table_write_t;
  signal material_applied : std_ulogic;
  signal table_applied    : std_ulogic;

  -- Pixel queue.
  signal go           : std_ulogic := '0';
  signal pixel_room   : std_ulogic;
  signal pixel_valid  : std_ulogic;
  signal pixel_fence  : std_ulogic;
  signal pixel_word   : pixel_word_t;
  signal pixel_out    : std_ulogic_vector(pixel_bits downto 0);
  signal output_valid : std_ulogic;
  signal output_taken : std_ulogic;

begin

  assert slices * words_per_beat <= channel_base + 1
    report "shading_core: slices is " & integer'image(slices) & "; at " & integer'image(words_per_beat)
           & " words a beat the next packet's words would overtake the upper slices"
    severity failure;
  assert colour_width >= colour_integer_bits and colour_width <= word_bits
    report "shading_core: colour_width is " & integer'image(colour_width) & ", it must lie in 10 to 32"
    severity failure;
  assert depth_width >= depth_bits and depth_width <= word_bits
    report "shading_core: depth_width is " & integer'image(depth_width) & ", it must lie in 16 to 32"
    severity failure;

  assert log_channels <= max_log_channels and (has_quadratic or log_channels = 0)
    report "shading_core: log_channels is " & integer'image(log_channels)
           & ", it must lie in 0 to 3, and be 0 without has_quadratic"
    severity failure;
  assert log_channels > 0 or not has_power
    report "shading_core: has_power needs log channels"
    severity failure;

  -- A word each: GHDL 2.0 writes a constant of more than 64 bits into Verilog as a string, whose bits are characters.
  description(0) <= std_ulogic_vector(to_unsigned(protocol_version + 2 ** 8 * log_channels
                                                  + choose(has_depth, 2 ** 10, 0) + choose(has_quadratic, 2 ** 11, 0)
                                                  + choose(has_power, 2 ** 12, 0), word_bits));
  description(1) <= std_ulogic_vector(to_unsigned(colour_width + 2 ** 8 * (colour_width - colour_integer_bits)
                                                  + 2 ** 16 * choose(has_depth, depth_width, 0)
                                                  + 2 ** 24 * phase_bits, word_bits));
  description(2) <= std_ulogic_vector(to_unsigned(max_extent + choose(log_channels > 0, 2 ** 12 * exp2_address_bits
                                                                      + 2 ** 16 * word_bits
                                                                      + 2 ** 24 * log_fraction_bits, 0), word_bits));
  -- In parts, as a natural has 31 bits.
  description(3) <= std_ulogic_vector(to_unsigned(choose(has_power, power_address_bits, 0), 4)
                                      & to_unsigned(choose(log_channels > 0, exp2_data_bits, 0), 4)
                                      & to_unsigned(core_version, 24));

  -- Setup stream: a queue whose flags are registers, then the decoder.
  beat_lanes : for k in 0 to words_per_beat - 1 generate
    beat_in(32 * words_per_beat + k) <= s_axis_tkeep(4 * k) and s_axis_tkeep(4 * k + 1)
                                        and s_axis_tkeep(4 * k + 2) and s_axis_tkeep(4 * k + 3);
    beat_words(k)                    <= beat(32 * k + 31 downto 32 * k);
  end generate beat_lanes;

  beat_in(32 * words_per_beat - 1 downto 0) <= s_axis_tdata;
  beat_in(beat_width - 1)                   <= s_axis_tlast;
  beat_keep                                 <= beat(33 * words_per_beat - 1 downto 32 * words_per_beat);
  beat_last                                 <= beat(beat_width - 1);

  beat_queue : entity sheen.stream_fifo
    generic map (
      width      => beat_width,
      depth_log2 => 4
    )
    port map (
      clk           => clk,
      rst           => rst,
      ready         => s_axis_tready,
      write         => s_axis_tvalid and s_axis_tready,
      write_data    => beat_in,
      valid         => beat_valid,
      data          => beat,
      taken         => beat_valid and beat_ready,
      write_address => open,
      fetch         => open,
      read_address  => open
    );

  decoder : entity sheen.packet_decoder
    generic map (
      words_per_beat => words_per_beat,
      has_depth      => has_depth,
      has_quadratic  => has_quadratic,
      log_channels   => log_channels,
      has_power      => has_power,
      register_count => register_count
    )
    port map (
      clk              => clk,
      rst              => rst,
      beat_valid       => beat_valid,
      beat_ready       => beat_ready,
      beat_words       => beat_words,
      beat_keep        => beat_keep,
      beat_last        => beat_last,
      job              => job,
      job_taken        => job_taken,
      words            => words,
      material         => material,
      table_write      => table_write,
      material_applied => material_applied,
      table_applied    => table_applied
    );

  geometry <= to_geometry(words(0 to channel_base - 1));

  walker : entity sheen.edge_walker
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
      command     => edge_part
    );

  span_vector <= to_vector(span);

  span_queue : entity sheen.stream_fifo
    generic map (
      width      => span_width,
      depth_log2 => span_queue_log2,
      reserve    => span_queue_reserve
    )
    port map (
      clk           => clk,
      rst           => rst,
      ready         => room,
      write         => push,
      write_data    => span_vector,
      valid         => head_valid,
      data          => head_vector,
      taken         => head_taken,
      write_address => push_address,
      fetch         => fetch,
      read_address  => fetch_address
    );

  head        <= to_span(head_vector);
  first_taken <= head_taken and head.first;

  spans : entity sheen.span_walker
    port map (
      clk        => clk,
      rst        => rst,
      head_valid => head_valid,
      head       => head,
      head_taken => head_taken,
      go         => go,
      command    => span_part,
      fragment   => walker_fragment
    );

  -- Channels follow the walkers by one clock, and so does their side of the span queue.
  follow : process (clk) is
  begin
    if rising_edge(clk) then
      fetch_late         <= fetch;
      fetch_address_late <= fetch_address;
      go                 <= pixel_room;
    end if;
  end process follow;

  command <= (edge_part => edge_part, span_part => span_part, push => push, push_address => push_address,
              fetch => fetch_late, fetch_address => fetch_address_late);

  -- The triangle's number of log channels, on the way of its channels' constants: job, edge part, span part.
  log_count : if log_channels > 0 generate
    signal job_log  : std_ulogic_vector(1 downto 0);
    signal edge_log : std_ulogic_vector(1 downto 0);
    signal span_log : std_ulogic_vector(1 downto 0);
  begin

    hand_over : process (clk) is
    begin
      if rising_edge(clk) then
        if job_taken then
          job_log <= job.log;
        end if;
        if edge_part.load then
          edge_log <= job_log;
        end if;
        if span_part.load and span_part.first then
          span_log <= edge_log;
        end if;
      end if;
    end process hand_over;

    join : process (all) is
    begin
      fragments(0)     <= walker_fragment;
      fragments(0).log <= span_log;
    end process join;

  else generate

    fragments(0) <= walker_fragment;

  end generate log_count;

  colour_channel : for c in 0 to colour_channels - 1 generate

    channel : entity sheen.forward_difference
      generic map (
        width        => colour_width,
        slices       => slices,
        family       => family,
        second_order => has_quadratic,
        value_bits   => colour_bits
      )
      port map (
        clk     => clk,
        command => command,
        present => '1',
        words   => words(channel_base + c * channel_words to channel_base + (c + 1) * channel_words - 1),
        value   => colour(c)
      );

  end generate colour_channel;

  depth_channel : if has_depth generate

    channel : entity sheen.forward_difference
      generic map (
        width        => depth_width,
        slices       => slices,
        family       => family,
        second_order => false,
        value_bits   => depth_bits
      )
      port map (
        clk     => clk,
        command => command,
        present => edge_part.depth,
        words   => words(depth_base to depth_base + linear_words - 1),
        value   => depth
      );

  end generate depth_channel;

  -- The fragment meets the upper slices of its channels.
  align : for k in 1 to slices generate

    delay : process (clk) is
    begin
      if rising_edge(clk) then
        fragments(k) <= fragments(k - 1);
        if rst then
          fragments(k).valid <= '0';
        end if;
      end if;
    end process delay;

  end generate align;

  highlights : if log_channels > 0 generate
    signal logs : log_vector_t(0 to log_channels - 1);
  begin

    log_channel : for k in 0 to log_channels - 1 generate
      constant base  : positive := channel_base + (colour_channels + k) * channel_words;
      signal value : std_ulogic_vector(log_t'length - 1 downto 0);
    begin

      channel : entity sheen.forward_difference
        generic map (
          width        => word_bits,
          slices       => slices,
          family       => family,
          second_order => true,
          value_bits   => log_t'length
        )
        port map (
          clk     => clk,
          command => command,
          present => '1',
          words   => words(base to base + channel_words - 1),
          value   => value
        );

      logs(k) <= signed(value);

    end generate log_channel;

    stage : entity sheen.highlight_stage
      generic map (
        log_channels => log_channels,
        has_power    => has_power
      )
      port map (
        clk              => clk,
        rst              => rst,
        fragment         => fragments(slices),
        red              => colour(0),
        green            => colour(1),
        blue             => colour(2),
        depth            => depth,
        logs             => logs,
        pending          => material,
        write            => table_write,
        material_applied => material_applied,
        table_applied    => table_applied,
        fragment_out     => lit_fragment,
        red_out          => lit_colour(0),
        green_out        => lit_colour(1),
        blue_out         => lit_colour(2),
        depth_out        => lit_depth
      );

  else generate

    lit_fragment     <= fragments(slices);
    lit_colour(0)    <= colour(0);
    lit_colour(1)    <= colour(1);
    lit_colour(2)    <= colour(2);
    lit_depth        <= depth;
    material_applied <= '0';
    table_applied    <= '0';

  end generate highlights;

  colours : entity sheen.colour_stage
    port map (
      clk         => clk,
      rst         => rst,
      description => description,
      fragment    => lit_fragment,
      red         => lit_colour(0),
      green       => lit_colour(1),
      blue        => lit_colour(2),
      depth       => lit_depth,
      valid       => pixel_valid,
      fence       => pixel_fence,
      word        => pixel_word
    );

  pixel_queue : entity sheen.stream_fifo
    generic map (
      width      => pixel_bits + 1,
      depth_log2 => pixel_queue_log2,
      reserve    => pixel_queue_reserve + choose(log_channels > 0, highlight_latency + log_channels, 0)
    )
    port map (
      clk           => clk,
      rst           => rst,
      ready         => pixel_room,
      write         => pixel_valid,
      write_data    => pixel_fence & pixel_word,
      valid         => output_valid,
      data          => pixel_out,
      taken         => output_taken,
      write_address => open,
      fetch         => open,
      read_address  => open
    );

  output_taken  <= output_valid and m_axis_tready;
  m_axis_tvalid <= output_valid;
  m_axis_tdata  <= pixel_out(pixel_bits - 1 downto 0);
  m_axis_tlast  <= pixel_out(pixel_bits);

end architecture rtl;
