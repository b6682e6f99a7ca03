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
-- skipped up to the next `last`; what stands before and after it is not touched. The header is judged in two clocks
-- while the payload arrives:
--
--   clock      t         t+1                     t+2               t+3
--   header     taken     opcode, flags, length   lengths compared  code valid
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
    -- Geometry, phases, colour channels, depth; stable while a triangle's job is valid and for two clocks after.
    words     : out word_vector_t(0 to register_count - 1)
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

  subtype length_t is unsigned(header_length_bits - 1 downto 0);
  subtype keep_t is std_ulogic_vector(words_per_beat - 1 downto 0);
  subtype code_t is std_ulogic_vector(1 downto 0);

  type phase_of_packet_t is (expect_header, payload, message);
  signal phase : phase_of_packet_t := expect_header;

  constant beat_index_bits : positive := 6;
  constant all_present     : keep_t   := (others => '1');
  constant one_present     : keep_t   := std_ulogic_vector(to_unsigned(1, words_per_beat));

  signal beat_index : unsigned(beat_index_bits - 1 downto 0);
  signal broken     : std_ulogic;                              -- the framing is not what the header announces
  signal header     : word_t;
  signal held       : word_vector_t(0 to words_per_beat - 1);  -- the header's beat, until the job before is taken
  signal pending    : std_ulogic := '0';
  signal write_words : word_vector_t(0 to words_per_beat - 1);
  signal registers  : word_vector_t(0 to register_count - 1);

  -- What the header says by itself.
  signal age         : unsigned(1 downto 0) := "00";  -- clocks since the header came, up to 3
  signal triangle    : std_ulogic;
  signal answered    : std_ulogic;                    -- a query or a fence
  signal known       : std_ulogic;
  signal served      : std_ulogic;                    -- triangle: this core has what the flags ask for
  signal expected    : unsigned(6 downto 0);          -- its payload words
  signal final_index : unsigned(beat_index_bits - 1 downto 0);
  signal final_less_one : unsigned(beat_index_bits - 1 downto 0);
  signal final_keep  : keep_t;
  signal at_final    : std_ulogic;                    -- the beat offered should be the last; valid at age 3
  signal code        : code_t;                        -- error code, 0 for none; valid at age 3

  signal accept       : std_ulogic;
  signal payload_beat : std_ulogic;
  signal sound        : std_ulogic;
  signal complete     : std_ulogic;
  signal emit         : std_ulogic;

  constant no_code           : code_t := "00";
  constant code_unknown      : code_t := std_ulogic_vector(to_unsigned(error_unknown_opcode, 2));
  constant code_bad_length   : code_t := std_ulogic_vector(to_unsigned(error_bad_length, 2));
  constant code_unsupported  : code_t := std_ulogic_vector(to_unsigned(error_unsupported, 2));

  function opcode_of (word : word_t) return unsigned is
  begin
    return unsigned(word(word_bits - 1 downto header_opcode_lsb));
  end function opcode_of;

  -- Payload words of a triangle packet, by its flags: number of log channels, depth, linear.
  subtype word_count_t is unsigned(6 downto 0);
  type lengths_t is array (0 to 15) of word_count_t;

  function make_lengths return lengths_t is
    variable words_of_channel : positive;
    variable result           : lengths_t;
  begin
    for flags in lengths_t'range loop
      words_of_channel := choose(flags mod 2 = 1, linear_words, quadratic_words);
      result(flags)    := to_unsigned(channel_base + (colour_channels + flags / 4) * words_of_channel
                                      + choose(flags / 2 mod 2 = 1, linear_words, 0), word_count_t'length);
    end loop;
    return result;
  end function make_lengths;

  constant lengths : lengths_t := make_lengths;

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
  complete     <= payload_beat and beat_last and sound and to_std_ulogic(age = 3 and code = no_code);
  emit         <= to_std_ulogic(phase = message and age = 3) and not pending;
  job.valid    <= pending;
  words        <= registers;

  framing : process (all) is
    variable inner : std_ulogic;
    variable outer : std_ulogic;
  begin
    inner := not beat_last and to_std_ulogic(beat_keep = all_present);
    outer := beat_last and to_std_ulogic(beat_keep = final_keep);
    -- No packet of three beats is sound, so the beats right behind the header need not wait for the verdict.
    if age /= 3 then
      sound <= inner and not broken;
    elsif at_final then
      sound <= outer and triangle and not broken;
    else
      sound <= inner and triangle and not broken;
    end if;
  end process framing;

  control : process (clk) is
  begin
    if rising_edge(clk) then
      if job_taken then
        pending <= '0';
      end if;

      if accept then
        if phase = expect_header then
          header     <= beat_words(0);
          held       <= beat_words;
          beat_index <= to_unsigned(1, beat_index_bits);
          if beat_last then
            broken <= not to_std_ulogic(beat_keep = one_present and opcode_of(beat_words(0)) /= opcode_triangle);
          else
            broken <= not to_std_ulogic(beat_keep = all_present);
          end if;
        else
          beat_index <= beat_index + 1;
          broken     <= not sound;
        end if;
        if not beat_last then
          phase <= payload;
        elsif complete then
          phase <= expect_header;
        else
          phase <= message;
        end if;
      end if;

      if complete then
        pending <= '1';
      end if;
      if payload_beat then
        job.message  <= '0';
        job.leftward <= header(flag_leftward_bit);
        job.linear   <= header(flag_linear_bit);
        job.depth    <= header(flag_depth_bit);
      end if;

      if emit then
        pending     <= '1';
        job.message <= '1';
        job.header  <= header;
        job.code    <= code;
        if code = no_code and broken = '1' then
          job.code <= code_bad_length;
        end if;
        phase <= expect_header;
      end if;

      if rst then
        phase   <= expect_header;
        pending <= '0';
      end if;
    end if;
  end process control;

  judge : process (clk) is
    variable length : length_t;
  begin
    if rising_edge(clk) then
      if accept = '1' and phase = expect_header then
        age <= "01";
      elsif age /= 3 then
        age <= age + 1;
      end if;

      -- First clock: what each field means.
      length   := unsigned(header(header_length_bits - 1 downto 0));
      triangle <= to_std_ulogic(opcode_of(header) = opcode_triangle);
      answered <= to_std_ulogic(opcode_of(header) = opcode_query or opcode_of(header) = opcode_fence);
      known    <= to_std_ulogic(opcode_of(header) <= opcode_fence);
      served   <= to_std_ulogic(header(header_opcode_lsb - 1 downto flag_log_channels_lsb) = "00000"
                                and (has_depth or header(flag_depth_bit) = '0')
                                and (has_quadratic or header(flag_linear_bit) = '1'));
      expected <= (others => '0');
      if opcode_of(header) = opcode_triangle then
        expected <= lengths(to_integer(unsigned(header(flag_log_channels_lsb + 1 downto flag_linear_bit))));
      end if;
      -- The header is word 0, so the last word is number `length`.
      if accept then
        at_final <= to_std_ulogic(beat_index = final_less_one);
      else
        at_final <= to_std_ulogic(beat_index = final_index);
      end if;
      final_index <= resize(length / words_per_beat, beat_index_bits);
      final_less_one <= resize(length / words_per_beat - 1, beat_index_bits);
      for lane in 0 to words_per_beat - 1 loop
        final_keep(lane) <= to_std_ulogic(lane <= to_integer(length mod words_per_beat));
      end loop;

      -- Second clock: the verdict.
      if not known then
        code <= code_unknown;
      elsif not (triangle or answered) then
        code <= code_unsupported;
      elsif length /= expected then
        code <= code_bad_length;
      elsif not (served or answered) then
        code <= code_unsupported;
      else
        code <= no_code;
      end if;
    end if;
  end process judge;

  -- A payload beat reaches its registers one clock after it was taken, so that their enables are registers, too.
  write_stage : process (clk) is
  begin
    if rising_edge(clk) then
      write_words <= beat_words;
    end if;
  end process write_stage;

  storage : for r in 0 to register_count - 1 generate
    constant quadratic_word : integer := position(r, false) + 1;  -- word number in its packet; 0: not in it
    constant linear_word    : integer := position(r, true) + 1;
    constant is_held        : boolean := beat_of(quadratic_word) = 0 and quadratic_word = linear_word;

    signal quadratic_write : std_ulogic := '0';
    signal linear_write    : std_ulogic := '0';
  begin

    enable : process (clk) is
    begin
      if rising_edge(clk) then
        if is_held then
          quadratic_write <= payload_beat and to_std_ulogic(beat_index = 1);
        elsif quadratic_word = linear_word then
          quadratic_write <= payload_beat and to_std_ulogic(beat_index = beat_of(quadratic_word));
        else
          quadratic_write <= payload_beat and not header(flag_linear_bit)
                             and to_std_ulogic(quadratic_word > 0 and beat_index = beat_of(quadratic_word));
          linear_write    <= payload_beat and header(flag_linear_bit)
                             and to_std_ulogic(linear_word > 0 and beat_index = beat_of(linear_word));
        end if;
      end if;
    end process enable;

    store : process (clk) is
    begin
      if rising_edge(clk) then
        if quadratic_write then
          registers(r) <= held(lane_of(quadratic_word)) when is_held else write_words(lane_of(quadratic_word));
        elsif linear_write then
          registers(r) <= write_words(lane_of(linear_word));
        end if;
      end if;
    end process store;

  end generate storage;

end architecture rtl;
