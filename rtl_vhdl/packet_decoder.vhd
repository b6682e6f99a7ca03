-- SPDX-License-Identifier: MIT
--
-- packet_decoder: beats of the setup stream in, jobs (triangles and messages) out, in order.
--
-- While a triangle is drawn, the words of the next one fill `words` (double-buffered setup); a complete packet raises
-- job.valid until the edge walker takes it. The header of the packet after that is taken in the meantime, so a stream
-- that is never late costs no clock between packets.
--
--   payload     [ 4 geometry ][ 6 phases ][ red 6|3 ][ green 6|3 ][ blue 6|3 ][ log 6|3 ... ][ depth 3|0 ]
--   word          0             4           10                                              (quadratic | linear)
--
-- A register's place in the beats is a constant for each form of the packet, so each word has one or two sources; depth
-- has two for each number of log channels.
--
-- Materials and power tables are for the highlight stage, and keep their place among the triangles: a material waits in
-- `material`, a table goes word by word into the bank that is not read, and a message of the packet's opcode follows
-- the pixels before it. The next material, or table, waits until that message has arrived.
--
-- Framing: every beat but the last is full, the last one holds exactly the words that the header announces and carries
-- `last`. Anything else, an unknown opcode, or a length or flag that the core can't serve gives one message and is
-- skipped up to the next `last`; what stands before and after it is not touched. The header is judged in two clocks
-- while the payload arrives:
--
--   clock      t         t+1                     t+2               t+3
--   header     taken     opcode, flags, length   lengths compared  code valid
--
-- Number formats: docs/packet-protocol.md. Latency: 1 clock from the last beat to job.valid (3 for a message).
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
    log_channels   : natural range 0 to max_log_channels := 0;
    has_power      : boolean  := false;  -- a power_rom for each of them
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
    words     : out word_vector_t(0 to register_count - 1);

    -- For the highlight stage, and what comes back from there: a message of the packet's opcode has arrived.
    material         : out material_t;
    table_write      : out table_write_t;
    material_applied : in std_ulogic := '0';
    table_applied    : in std_ulogic := '0'
  );

  attribute latency : integer;
  attribute latency of packet_decoder : entity is 1;
end entity packet_decoder;

architecture rtl of packet_decoder is

  constant channel_base  : natural  := geometry_words + phase_words;
  constant channel_words : positive := choose(has_quadratic, quadratic_words, linear_words);
  constant depth_base    : positive := channel_base + (colour_channels + log_channels) * channel_words;

  -- Payload index of register r in a packet of one form, with this many log channels; -1: not in it.
  function position (r : natural; linear : boolean; logs : natural) return integer is
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
      return channel_base + (colour_channels + logs) * packet_words + r - depth_base;
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

  -- Payload words of a triangle packet, by its flags: number of log channels, depth, linear.
  subtype word_count_t is unsigned(8 downto 0);
  type lengths_t is array (0 to 15) of word_count_t;

  type phase_of_packet_t is (expect_header, payload, message);
  signal phase : phase_of_packet_t := expect_header;

  -- Beats are counted up to the longest packet's, and no further.
  constant beat_index_bits : positive := choose(has_power, power_word_bits + 1, 6);
  constant all_present     : keep_t   := (others => '1');
  constant one_present     : keep_t   := std_ulogic_vector(to_unsigned(1, words_per_beat));

  signal beat_index : unsigned(beat_index_bits - 1 downto 0);
  signal broken     : std_ulogic;                              -- a beat before the last one was not full
  signal last_keep  : keep_t;
  signal settled    : std_ulogic;                              -- in phase message since a clock ago
  signal framed     : std_ulogic;                              -- the last beat was the one that the header announces
  signal header     : word_t;
  signal held       : word_vector_t(0 to words_per_beat - 1);  -- the header's beat, until the job before is taken
  signal pending    : std_ulogic := '0';
  signal write_words : word_vector_t(0 to words_per_beat - 1);
  signal registers  : word_vector_t(0 to register_count - 1);

  -- What the header says by itself.
  signal age         : unsigned(1 downto 0) := "00";  -- clocks since the header came, up to 3
  signal triangle    : std_ulogic;
  signal known       : std_ulogic;
  signal served      : std_ulogic;                    -- this core has what opcode and flags ask for
  signal expected    : word_count_t;                  -- payload words
  signal final_index : unsigned(beat_index_bits - 1 downto 0);
  signal final_less_one : unsigned(beat_index_bits - 1 downto 0);
  signal final_keep  : keep_t;
  signal at_final    : std_ulogic;                    -- the beat offered should be the last; valid at age 3
  signal code        : code_t;                        -- error code, 0 for none; valid at age 3

  signal accept       : std_ulogic;
  signal payload_beat : std_ulogic;
  signal complete     : std_ulogic;
  signal emit         : std_ulogic;
  signal good         : std_ulogic;                   -- what is emitted is no error
  signal kinds_served : std_ulogic;

  -- Materials and tables. The log channels' kinds stand in word 1.
  constant kinds_lsb      : natural := colour_channels * material_field_bits - word_bits;
  signal is_material      : std_ulogic;
  signal material_waits   : std_ulogic := '0';        -- it has not arrived at the highlight stage
  signal is_table         : std_ulogic := '0';        -- the packet is a power table
  signal table_waits      : std_ulogic := '0';
  signal written          : std_ulogic;               -- no word, or one that goes in this clock, waits in `held`
  signal left_over        : std_ulogic;               -- a word waits there

  constant no_code           : code_t := "00";
  constant code_unknown      : code_t := std_ulogic_vector(to_unsigned(error_unknown_opcode, 2));
  constant code_bad_length   : code_t := std_ulogic_vector(to_unsigned(error_bad_length, 2));
  constant code_unsupported  : code_t := std_ulogic_vector(to_unsigned(error_unsupported, 2));

  function opcode_of (word : word_t) return unsigned is
  begin
    return unsigned(word(word_bits - 1 downto header_opcode_lsb));
  end function opcode_of;

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

  beat_ready   <= '0' when phase = message or (phase = payload and (pending = '1' or written = '0')) else '1';
  accept       <= beat_valid and beat_ready;
  payload_beat <= accept and to_std_ulogic(phase = payload);
  complete     <= payload_beat and beat_last and at_final and triangle and not broken
                  and to_std_ulogic(beat_keep = final_keep and age = 3 and code = no_code);
  is_material  <= to_std_ulogic(opcode_of(header) = opcode_material);
  emit         <= to_std_ulogic(phase = message and age = 3) and settled and not pending
                  and not (is_material and material_waits) and not left_over;
  good         <= framed and kinds_served and to_std_ulogic(code = no_code);
  -- A core without power tables refuses a material that asks for one.
  kinds_served <= to_std_ulogic(has_power) or not is_material
                  or not (or registers(1)(kinds_lsb + max_log_channels - 1 downto kinds_lsb));
  job.valid    <= pending;
  words        <= registers;

  -- Every sound triangle is so long that its last beat finds it judged; other packets wait in phase message.
  framing : process (clk) is
  begin
    if rising_edge(clk) then
      if accept then
        last_keep <= beat_keep;
        if phase = expect_header then
          broken <= not beat_last and to_std_ulogic(beat_keep /= all_present);
        elsif not beat_last then
          broken <= broken or to_std_ulogic(beat_keep /= all_present);
        end if;
      end if;
      settled <= to_std_ulogic(phase = message);
      framed  <= not broken and to_std_ulogic(beat_index = final_index + 1 and last_keep = final_keep);
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
          beat_index <= to_unsigned(1, beat_index_bits);
        elsif beat_index /= 2 ** beat_index_bits - 1 then
          beat_index <= beat_index + 1;
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
        job.log      <= "00";
        if log_channels > 0 then
          job.log <= header(flag_log_channels_lsb + 1 downto flag_log_channels_lsb);
        end if;
      end if;

      if emit then
        pending     <= '1';
        job.message <= '1';
        job.header  <= header;
        job.code    <= code;
        if code = no_code and framed = '0' then
          job.code <= code_bad_length;
        elsif code = no_code and kinds_served = '0' then
          job.code <= code_unsupported;
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
    variable length   : length_t;
    variable no_flags : std_ulogic;
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
      known    <= to_std_ulogic(opcode_of(header) <= opcode_fence);
      no_flags := to_std_ulogic(header(header_opcode_lsb - 1 downto header_flags_lsb) = "00000000");
      expected <= (others => '0');
      served   <= '0';
      if opcode_of(header) = opcode_triangle then
        expected <= lengths(to_integer(unsigned(header(flag_log_channels_lsb + 1 downto flag_linear_bit))));
        served   <= to_std_ulogic(header(header_opcode_lsb - 1 downto flag_log_channels_lsb + 2) = "000"
                                  and unsigned(header(flag_log_channels_lsb + 1 downto flag_log_channels_lsb))
                                  <= log_channels
                                  and (has_depth or header(flag_depth_bit) = '0')
                                  and (has_quadratic or header(flag_linear_bit) = '1'));
      elsif opcode_of(header) = opcode_material then
        expected <= to_unsigned(material_words, word_count_t'length);
        served   <= no_flags and to_std_ulogic(log_channels > 0);
      elsif opcode_of(header) = opcode_table then
        expected <= to_unsigned(power_words, word_count_t'length);
        served   <= no_flags and to_std_ulogic(has_power);
      elsif opcode_of(header) /= opcode_spans then
        served <= '1';
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
      elsif length /= expected and opcode_of(header) /= opcode_spans then
        code <= code_bad_length;
      elsif not served then
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
      if accept = '1' and (phase = expect_header or is_table = '1') then
        held <= beat_words;
      end if;
    end if;
  end process write_stage;

  -- Geometry, phases and channels. A log channel that the packet hasn't is never read.
  storage : for r in 0 to depth_base - 1 generate
    constant quadratic_word : integer := position(r, false, 0) + 1;  -- word number in its packet; 0: not in it
    constant linear_word    : integer := position(r, true, 0) + 1;
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

  -- Depth has its place behind the log channels: a source for each number of them, quadratic and linear.
  depth_storage : for r in depth_base to register_count - 1 generate

    function word_number (form : natural) return natural is
    begin
      return position(r, form mod 2 = 1, form / 2) + 1;
    end function word_number;

    signal write : std_ulogic_vector(0 to 2 * log_channels + 1) := (others => '0');
  begin

    enable : process (clk) is
      variable form : unsigned(2 downto 0);
    begin
      if rising_edge(clk) then
        form := unsigned(header(flag_log_channels_lsb + 1 downto flag_log_channels_lsb)) & header(flag_linear_bit);
        for k in write'range loop
          write(k) <= payload_beat and to_std_ulogic(form = k and beat_index = beat_of(word_number(k)));
        end loop;
      end if;
    end process enable;

    store : process (clk) is
    begin
      if rising_edge(clk) then
        for k in write'range loop
          if write(k) then
            registers(r) <= write_words(lane_of(word_number(k)));
          end if;
        end loop;
      end if;
    end process store;

  end generate depth_storage;

  -- Fields of 12 bits from bit 0 of word 0: ambient red, green, blue u8.4, the log channels' kinds.
  materials : if log_channels > 0 generate

    take : process (clk) is
      constant cut  : natural  := ambient_fraction_bits - colour_sum_fraction_bits;
      constant kept : positive := component_bits + colour_sum_fraction_bits;
      variable fields : std_ulogic_vector(2 * word_bits - 1 downto 0);
    begin
      if rising_edge(clk) then
        fields := registers(1) & registers(0);
        if material_applied then
          material_waits <= '0';
        end if;
        if emit and good and is_material then
          material.red   <= unsigned(fields(kept + cut - 1 downto cut));
          material.green <= unsigned(fields(material_field_bits + kept + cut - 1 downto material_field_bits + cut));
          material.blue  <= unsigned(fields(2 * material_field_bits + kept + cut - 1
                                            downto 2 * material_field_bits + cut));
          material.power <= registers(1)(kinds_lsb + max_log_channels - 1 downto kinds_lsb);
          material_waits <= '1';
        end if;
        if rst then
          material_waits <= '0';
        end if;
      end if;
    end process take;

  else generate

    material       <= no_material;
    material_waits <= '0';

  end generate materials;

  -- A table's words, one a clock, out of the beat that is held.
  tables : if has_power generate
    signal left    : unsigned(2 downto 0) := "000";  -- words in `held` that are not written yet
    signal lane    : unsigned(1 downto 0) := "00";   -- the first of them
    signal address : unsigned(power_word_bits - 1 downto 0);
    signal bank    : std_ulogic := '1';
    signal writes  : std_ulogic;
  begin

    writes    <= is_table and left_over and not table_waits;
    left_over <= or left;
    written   <= not is_table or (not table_waits and not (left(2) or left(1)));

    write_word : process (clk) is
      variable present : unsigned(2 downto 0);
    begin
      if rising_edge(clk) then
        table_write.valid   <= writes;
        table_write.bank    <= bank;
        table_write.address <= address;
        for k in 0 to words_per_beat - 1 loop
          if lane = k then
            table_write.data <= held(k);
          end if;
        end loop;

        if writes then
          left    <= left - 1;
          lane    <= lane + 1;
          address <= address + 1;
        end if;
        present := "000";
        for k in 0 to words_per_beat - 1 loop
          if beat_keep(k) then
            present := present + 1;
          end if;
        end loop;
        if accept then
          if phase = expect_header then
            is_table <= to_std_ulogic(opcode_of(beat_words(0)) = opcode_table);
            address  <= (others => '0');
            left     <= (others => '0');
            lane     <= "01";
            if opcode_of(beat_words(0)) = opcode_table then
              left <= present - 1;
            end if;
          else
            lane <= "00";
            if is_table then
              left <= present;
            end if;
          end if;
        end if;

        if table_applied then
          table_waits <= '0';
        end if;
        if emit and good and is_table then
          bank        <= not bank;
          table_waits <= '1';
        end if;
        if rst then
          is_table          <= '0';
          left              <= "000";
          bank              <= '1';
          table_waits       <= '0';
          table_write.valid <= '0';
        end if;
      end if;
    end process write_word;

  else generate

    is_table    <= '0';
    table_waits <= '0';
    left_over   <= '0';
    written     <= '1';
    table_write <= no_table_write;

  end generate tables;

end architecture rtl;
