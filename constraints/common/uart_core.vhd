-- SPDX-License-Identifier: MIT
--
-- uart_core: a shading core between two wires of a serial line, 8N1; what every board's top is made of.
--
--   rxd -> uart_receiver -> packet_framer -> shading_core -> word_serializer -> uart_transmitter -> txd
--               | fault
--               +--------> reset of everything behind it
--
-- Bytes in are the packet words of a packet file, lowest byte first; bytes out are the words of a pixel file, likewise.
-- A line break (or any byte without its stop bit) resets the core: whatever state a broken transfer left is gone.
-- After power-up the core is held in reset until a counter has run through; flip-flops start at their initial values.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library sheen;
  use sheen.sheen_constants_pkg.all;
  use sheen.sheen_pkg.all;

entity uart_core is
  generic (
    clocks_per_bit : positive;
    words_per_beat : positive := 1;
    has_depth      : boolean  := true;
    has_quadratic  : boolean  := true
  );
  port (
    clk : in std_ulogic;

    rxd : in std_ulogic;
    txd : out std_ulogic;

    receiving    : out std_ulogic;  -- bytes came in lately
    transmitting : out std_ulogic;  -- bytes go out
    lost         : out std_ulogic;  -- words came faster than the core takes them; until the next reset
    alive        : out std_ulogic   -- blinks with the clock
  );
end entity uart_core;

architecture rtl of uart_core is

  constant blink_bits : positive := 24;

  signal power_up : unsigned(3 downto 0) := (others => '0');
  signal powered  : std_ulogic := '0';
  signal rst      : std_ulogic := '1';
  signal fault    : std_ulogic;

  signal received_valid : std_ulogic;
  signal received       : std_ulogic_vector(7 downto 0);
  signal sent_valid     : std_ulogic;
  signal sent_ready     : std_ulogic;
  signal sent           : std_ulogic_vector(7 downto 0);

  signal setup_tdata  : std_ulogic_vector(32 * words_per_beat - 1 downto 0);
  signal setup_tkeep  : std_ulogic_vector(4 * words_per_beat - 1 downto 0);
  signal setup_tlast  : std_ulogic;
  signal setup_tvalid : std_ulogic;
  signal setup_tready : std_ulogic;
  signal pixel_tdata  : pixel_word_t;
  signal pixel_tvalid : std_ulogic;
  signal pixel_tready : std_ulogic;

  signal beat_lost : std_ulogic;
  signal any_lost  : std_ulogic := '0';
  signal blink     : unsigned(blink_bits - 1 downto 0)      := (others => '0');
  signal lately    : unsigned(blink_bits - 4 downto 0)      := (others => '0');  -- clocks since the last byte

begin

  reset : process (clk) is
  begin
    if rising_edge(clk) then
      if not powered then
        power_up <= power_up + 1;
        powered  <= and power_up;
      end if;
      rst <= fault or not powered;
    end if;
  end process reset;

  receiver : entity sheen.uart_receiver
    generic map (
      clocks_per_bit => clocks_per_bit
    )
    port map (
      clk        => clk,
      rst        => not powered,
      rxd        => rxd,
      byte_valid => received_valid,
      octet       => received,
      fault      => fault
    );

  framer : entity sheen.packet_framer
    generic map (
      words_per_beat => words_per_beat
    )
    port map (
      clk           => clk,
      rst           => rst,
      byte_valid    => received_valid,
      octet          => received,
      m_axis_tdata  => setup_tdata,
      m_axis_tkeep  => setup_tkeep,
      m_axis_tlast  => setup_tlast,
      m_axis_tvalid => setup_tvalid,
      m_axis_tready => setup_tready,
      lost          => beat_lost
    );

  shading : entity sheen.shading_core
    generic map (
      words_per_beat => words_per_beat,
      has_depth      => has_depth,
      has_quadratic  => has_quadratic
    )
    port map (
      clk           => clk,
      rst           => rst,
      s_axis_tdata  => setup_tdata,
      s_axis_tkeep  => setup_tkeep,
      s_axis_tlast  => setup_tlast,
      s_axis_tvalid => setup_tvalid,
      s_axis_tready => setup_tready,
      m_axis_tdata  => pixel_tdata,
      m_axis_tlast  => open,
      m_axis_tvalid => pixel_tvalid,
      m_axis_tready => pixel_tready
    );

  serializer : entity sheen.word_serializer
    port map (
      clk           => clk,
      rst           => rst,
      s_axis_tdata  => pixel_tdata,
      s_axis_tvalid => pixel_tvalid,
      s_axis_tready => pixel_tready,
      byte_valid    => sent_valid,
      byte_ready    => sent_ready,
      octet          => sent
    );

  transmitter : entity sheen.uart_transmitter
    generic map (
      clocks_per_bit => clocks_per_bit
    )
    port map (
      clk        => clk,
      rst        => rst,
      byte_valid => sent_valid,
      byte_ready => sent_ready,
      octet       => sent,
      txd        => txd
    );

  lamps : process (clk) is
  begin
    if rising_edge(clk) then
      blink        <= blink + 1;
      alive        <= blink(blink'left);
      transmitting <= not sent_ready;
      any_lost     <= (any_lost or beat_lost) and not rst;
      lost         <= any_lost;
      receiving    <= or lately;
      if received_valid then
        lately <= (others => '1');
      elsif lately /= 0 then
        lately <= lately - 1;
      end if;
    end if;
  end process lamps;

end architecture rtl;
