-- SPDX-License-Identifier: MIT
--
-- packet_decoder: beats of the setup stream in, jobs (triangles and messages) out, in order.
--
-- While a triangle is drawn, the words of the next one fill `words` (double-buffered setup); a complete packet raises
-- job.valid until the edge walker takes it. The header of the packet after that is taken in the meantime, so a stream
-- that is never late costs no clock between packets.
--
--   payload     [ 4 geometry ][ 6 phases ][ red 6|3 ][ green 6|3 ][ blue 6|3 ][ depth 3|0 ]
--   word          0             4           10                                              (quadratic | linear)
--
-- A register's place in the beats is a constant for each form of the packet, so each word has one or two sources.
--
-- Framing: every beat but the last is full, the last one holds exactly the words that the header announces and carries
-- `last`. Anything else, an unknown opcode, or a length or flag that the core can't serve gives one message and is
-- skipped up to the next `last`; what stands before and after it is not touched.
--
-- Number formats: docs/packet-protocol.md. Latency: 1 clock from the last beat to job.valid (2 for a message).
-- Model: hls/include/sheen/hls/packet_decoder.hpp.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library sheen;
  use sheen.sheen_constants_pkg.all;
  use sheen.sheen_pkg.all;

entity packet_decoder is
  generic (
    words_per_beat : positive := 2;
    has_depth      : boolean  := true;
    has_quadratic  : boolean  := true;
    register_count : positive := geometry_words + phase_words + colour_channels * quadratic_words + linear_words
  );
  port (
    clk : in std_ulogic;
    rst : in std_ulogic;

    beat_valid : in std_ulogic;
    beat_ready : out std_ulogic;
    beat_words : in word_vector_t(0 to words_per_beat - 1);
    beat_keep  : in std_ulogic_vector(words_per_beat - 1 downto 0);  -- bit k: word k is present
    beat_last  : in std_ulogic;

    job       : out job_t;
    job_taken : in std_ulogic;
    words     : out word_vector_t(0 to register_count - 1)  -- geometry, phases, colour channels, depth
  );

  attribute latency : integer;
  attribute latency of packet_decoder : entity is 1;
end entity packet_decoder;

architecture rtl of packet_decoder is

  constant channel_base  : natural  := geometry_words + phase_words;
  constant channel_words : positive := choose(has_quadratic, quadratic_words, linear_words);
  constant depth_base    : positive := channel_base + colour_channels * channel_words;

  -- Payload index of register r in a packet of one form; -1: not in it.
  function position (r : natural; linear : boolean) return integer is
    variable packet_words : positive := quadratic_words;
    variable channel      : natural;
    variable k            : natural;
  begin
    if linear then
      packet_words := linear_words;
    end if;
    if r < channel_base then
      return r;
    elsif r >= depth_base then
      return channel_base + colour_channels * packet_words + r - depth_base;
    end if;
    channel := (r - channel_base) / channel_words;
    k       := (r - channel_base) mod channel_words;
    if k >= packet_words or packet_words > channel_words then
      return -1;
    end if;
    return channel_base + channel * packet_words + k;
  end function position;

  type phase_of_packet_t is (expect_header, payload, message, skip);
  signal phase : phase_of_packet_t := expect_header;

  constant beat_index_bits : positive := 6;
  constant all_present     : std_ulogic_vector(words_per_beat - 1 downto 0) := (others => '1');

  signal beat_index : unsigned(beat_index_bits - 1 downto 0);
  signal header     : word_t;
  signal held       : word_vector_t(0 to words_per_beat - 1);  -- the header's beat, until the job before is taken
  signal code       : std_ulogic_vector(1 downto 0);           -- of the message under way
  signal skip_after : std_ulogic;                              -- the packet's last beat is still to come
  signal pending    : std_ulogic := '0';
  signal registers  : word_vector_t(0 to register_count - 1);

  signal accept       : std_ulogic;
  signal payload_beat : std_ulogic;

  -- 0, or the error code that a header deserves by itself.
  function classify (word : word_t) return natural is
    constant opcode        : natural                       := to_integer(unsigned(word(31 downto header_opcode_lsb)));
    constant length        : unsigned(header_length_bits - 1 downto 0) := unsigned(word(header_length_bits - 1 downto 0));
    variable log_words     : unsigned(6 downto 0);
    variable expected      : unsigned(6 downto 0);
    variable log_channels  : unsigned(1 downto 0);
  begin
    if opcode > opcode_fence then
      return error_unknown_opcode;
    elsif opcode = opcode_query or opcode = opcode_fence then
      if length /= 0 then
        return error_bad_length;
      end if;
      return 0;
    elsif opcode /= opcode_triangle then
      return error_unsupported;
    end if;
    log_channels := unsigned(word(flag_log_channels_lsb + 1 downto flag_log_channels_lsb));
    if word(flag_linear_bit) then
      expected  := to_unsigned(channel_base + colour_channels * linear_words, 7);
      log_words := to_unsigned(linear_words, 7);
    else
      expected  := to_unsigned(channel_base + colour_channels * quadratic_words, 7);
      log_words := to_unsigned(quadratic_words, 7);
    end if;
    if log_channels(0) then
      expected := expected + log_words;
    end if;
    if log_channels(1) then
      expected := expected + (log_words sll 1);
    end if;
    if word(flag_depth_bit) then
      expected := expected + linear_words;
    end if;
    if length /= expected then
      return error_bad_length;
    elsif (word(flag_linear_bit) = '0' and not has_quadratic) or (word(flag_depth_bit) = '1' and not has_depth)
          or word(header_opcode_lsb - 1 downto flag_log_channels_lsb) /= "00000" then
      return error_unsupported;
    end if;
    return 0;
  end function classify;

  -- Beat and lane of word number n; the header is word 0.
  function beat_of (n : natural) return natural is
  begin
    return n / words_per_beat;
  end function beat_of;

  function lane_of (n : natural) return natural is
  begin
    return n mod words_per_beat;
  end function lane_of;

begin

  assert words_per_beat = 1 or words_per_beat = 2 or words_per_beat = 4
    report "packet_decoder: words_per_beat is " & integer'image(words_per_beat) & ", it must be 1, 2 or 4"
    severity failure;

  beat_ready   <= '0' when phase = message or (phase = payload and pending = '1') else '1';
  accept       <= beat_valid and beat_ready;
  payload_beat <= accept and to_std_ulogic(phase = payload);
  job.valid    <= pending;
  words        <= registers;

  control : process (clk) is
    variable header_code : natural range 0 to 3;
    variable is_triangle : boolean;
    variable whole       : boolean;
    variable length      : unsigned(header_length_bits - 1 downto 0);
    variable at_final    : boolean;
    variable final_keep  : std_ulogic_vector(words_per_beat - 1 downto 0);
  begin
    if rising_edge(clk) then
      if job_taken then
        pending <= '0';
      end if;

      case phase is

        when expect_header =>
          if accept then
            header_code := classify(beat_words(0));
            is_triangle := unsigned(beat_words(0)(31 downto header_opcode_lsb)) = opcode_triangle;
            if is_triangle then
              whole := beat_last = '0' and beat_keep = all_present;
            else
              whole := beat_last = '1' and unsigned(beat_keep) = 1;
            end if;
            header     <= beat_words(0);
            held       <= beat_words;
            beat_index <= to_unsigned(1, beat_index_bits);
            skip_after <= not beat_last;
            code       <= std_ulogic_vector(to_unsigned(header_code, 2));
            if header_code = 0 and not whole then
              code <= std_ulogic_vector(to_unsigned(error_bad_length, 2));
            end if;
            phase <= payload when is_triangle and whole and header_code = 0 else message;
          end if;

        when payload =>
          if accept then
            length     := unsigned(header(header_length_bits - 1 downto 0));
            at_final   := beat_index = length / words_per_beat;
            final_keep := (others => '0');
            for lane in 0 to words_per_beat - 1 loop
              final_keep(lane) := to_std_ulogic(lane <= to_integer(length mod words_per_beat));
            end loop;
            beat_index <= beat_index + 1;
            skip_after <= not beat_last;
            code       <= std_ulogic_vector(to_unsigned(error_bad_length, 2));
            if at_final and beat_last = '1' and beat_keep = final_keep then
              pending    <= '1';
              job.message  <= '0';
              job.leftward <= header(flag_leftward_bit);
              job.linear   <= header(flag_linear_bit);
              job.depth    <= header(flag_depth_bit);
              phase        <= expect_header;
            elsif at_final or beat_last = '1' or beat_keep /= all_present then
              phase <= message;
            end if;
          end if;

        when message =>
          if not pending then
            pending   <= '1';
            job.message <= '1';
            job.code    <= code;
            job.header  <= header;
            phase       <= skip when skip_after else expect_header;
          end if;

        when skip =>
          if accept and beat_last then
            phase <= expect_header;
          end if;

      end case;

      if rst then
        phase     <= expect_header;
        pending <= '0';
      end if;
    end if;
  end process control;

  storage : for r in 0 to register_count - 1 generate
    constant quadratic_place : integer := position(r, false);
    constant linear_place    : integer := position(r, true);
  begin

    store : process (clk) is
    begin
      if rising_edge(clk) then
        if payload_beat then
          if quadratic_place = linear_place then
            if beat_of(quadratic_place + 1) = 0 then
              if beat_index = 1 then
                registers(r) <= held(lane_of(quadratic_place + 1));
              end if;
            elsif beat_index = beat_of(quadratic_place + 1) then
              registers(r) <= beat_words(lane_of(quadratic_place + 1));
            end if;
          else
            if quadratic_place >= 0 and header(flag_linear_bit) = '0' and beat_index = beat_of(quadratic_place + 1) then
              registers(r) <= beat_words(lane_of(quadratic_place + 1));
            end if;
            if linear_place >= 0 and header(flag_linear_bit) = '1' and beat_index = beat_of(linear_place + 1) then
              registers(r) <= beat_words(lane_of(linear_place + 1));
            end if;
          end if;
        end if;
      end if;
    end process store;

  end generate storage;

end architecture rtl;
