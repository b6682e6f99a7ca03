-- SPDX-License-Identifier: MIT
--
-- packet_framer: bytes into the beats of a setup stream.
--
-- Four bytes make a word, the lowest first. Words are packets as in a file: only headers frame, bits 15..0 of a header
-- are the number of words that follow it, whatever its opcode. Each packet starts a beat; tkeep marks the words of its
-- last beat, and tlast stands on it (docs/packet-protocol.md).
--
-- A serial line can't wait: when a beat is complete before the one before it was taken, it is dropped, and `lost` tells
-- so for one clock. A host that waits for answers never gets there (constraints/README.md).

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library sheen;
  use sheen.sheen_constants_pkg.all;
  use sheen.sheen_pkg.all;

entity packet_framer is
  generic (
    words_per_beat : positive := 2
  );
  port (
    clk : in std_ulogic;
    rst : in std_ulogic;

    byte_valid : in std_ulogic;
    octet       : in std_ulogic_vector(7 downto 0);

    m_axis_tdata  : out std_ulogic_vector(32 * words_per_beat - 1 downto 0);
    m_axis_tkeep  : out std_ulogic_vector(4 * words_per_beat - 1 downto 0);
    m_axis_tlast  : out std_ulogic;
    m_axis_tvalid : out std_ulogic;
    m_axis_tready : in std_ulogic;

    lost : out std_ulogic
  );
end entity packet_framer;

architecture rtl of packet_framer is

  subtype length_t is unsigned(header_length_bits - 1 downto 0);
  subtype byte_index_t is natural range 0 to 3;
  subtype lane_t is natural range 0 to 3;

  signal word       : word_t;
  signal word_valid : std_ulogic   := '0';
  signal byte_index : byte_index_t := 0;

  signal in_packet : std_ulogic := '0';  -- a header's payload is expected
  signal remaining : length_t;           -- payload words that are still to come
  signal lane      : lane_t     := 0;
  signal lanes     : word_vector_t(0 to words_per_beat - 1);
  signal last      : std_ulogic;
  signal valid     : std_ulogic := '0';
  signal keep      : std_ulogic_vector(words_per_beat - 1 downto 0);

begin

  m_axis_tvalid <= valid;
  m_axis_tlast  <= last;

  beat : for k in 0 to words_per_beat - 1 generate
    m_axis_tdata(32 * k + 31 downto 32 * k) <= lanes(k);
    m_axis_tkeep(4 * k + 3 downto 4 * k)    <= (others => keep(k));
  end generate beat;

  collect : process (clk) is
  begin
    if rising_edge(clk) then
      word_valid <= '0';
      if byte_valid then
        word       <= octet & word(word_bits - 1 downto 8);
        word_valid <= to_std_ulogic(byte_index = 3);
        byte_index <= 0 when byte_index = 3 else byte_index + 1;
      end if;
      if rst then
        byte_index <= 0;
        word_valid <= '0';
      end if;
    end if;
  end process collect;

  frame : process (clk) is
    variable left     : length_t;
    variable ends     : boolean;
    variable overtake : std_ulogic;
  begin
    if rising_edge(clk) then
      lost     <= '0';
      overtake := valid and not m_axis_tready;
      if m_axis_tready then
        valid <= '0';
      end if;

      if word_valid then
        left := remaining - 1 when in_packet else unsigned(word(header_length_bits - 1 downto 0));
        ends := left = 0;
        remaining <= left;
        in_packet <= to_std_ulogic(not ends);
        lane      <= 0 when ends or lane = words_per_beat - 1 else lane + 1;
        if overtake then
          lost <= '1';
        else
          for k in lanes'range loop
            keep(k) <= to_std_ulogic(k <= lane);
            if k = lane then
              lanes(k) <= word;
            end if;
          end loop;
          last  <= to_std_ulogic(ends);
          valid <= to_std_ulogic(ends or lane = words_per_beat - 1);
        end if;
      end if;

      if rst then
        in_packet <= '0';
        lane      <= 0;
        valid     <= '0';
        lost      <= '0';
      end if;
    end if;
  end process frame;

end architecture rtl;
