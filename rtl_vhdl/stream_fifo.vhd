-- SPDX-License-Identifier: MIT
--
-- stream_fifo: a queue with registered flags and an output register.
--
-- Both flags are sign bits of up/down counters, so nothing is compared: `ready` falls while `reserve` places are still
-- free (for writers that see it some clocks late), `valid` says that the output register holds an entry. The memory is
-- read one clock ahead into that register: it maps to LUT RAM or to block RAM alike. `write_address`, `fetch` and
-- `read_address` let followers keep memories of their own in step (the channels' shares of the span queue).
--
-- Latency: 2 clocks from write to valid. Model: hls/include/sheen/hls/stream_fifo.hpp.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

entity stream_fifo is
  generic (
    width      : positive;
    depth_log2 : positive;
    reserve    : natural := 0
  );
  port (
    clk : in std_ulogic;
    rst : in std_ulogic;

    -- Writer: it heeds ready and reserve.
    ready      : out std_ulogic;
    write      : in std_ulogic;
    write_data : in std_ulogic_vector(width - 1 downto 0);

    -- Reader: taken only while valid.
    valid : out std_ulogic;
    data  : out std_ulogic_vector(width - 1 downto 0);
    taken : in std_ulogic;

    -- Followers.
    write_address : out unsigned(depth_log2 - 1 downto 0);
    fetch         : out std_ulogic;
    read_address  : out unsigned(depth_log2 - 1 downto 0)
  );

  attribute latency : integer;
  attribute latency of stream_fifo : entity is 2;
end entity stream_fifo;

architecture rtl of stream_fifo is

  type memory_t is array (0 to 2 ** depth_log2 - 1) of std_ulogic_vector(width - 1 downto 0);
  signal memory : memory_t;

  subtype counter_t is signed(depth_log2 + 1 downto 0);
  -- Places left before ready falls, and entries in the memory, both less 1.
  signal room   : counter_t := to_signed(2 ** depth_log2 - reserve - 1, depth_log2 + 2);
  signal stored : counter_t := to_signed(-1, depth_log2 + 2);

  signal next_write  : unsigned(depth_log2 - 1 downto 0) := (others => '0');
  signal next_read   : unsigned(depth_log2 - 1 downto 0) := (others => '0');
  signal holds_entry : std_ulogic                        := '0';
  signal fetches     : std_ulogic;

begin

  assert reserve < 2 ** depth_log2
    report "stream_fifo: reserve is " & integer'image(reserve) & ", it must be below the "
           & integer'image(2 ** depth_log2) & " places"
    severity failure;

  ready         <= not room(room'left);
  valid         <= holds_entry;
  fetches       <= not stored(stored'left) and (not holds_entry or taken);
  write_address <= next_write;
  fetch         <= fetches;
  read_address  <= next_read;

  storage : process (clk) is
  begin
    if rising_edge(clk) then
      if write then
        memory(to_integer(next_write)) <= write_data;
      end if;
      if fetches then
        data <= memory(to_integer(next_read));
      end if;
    end if;
  end process storage;

  control : process (clk) is
  begin
    if rising_edge(clk) then
      if write then
        next_write <= next_write + 1;
      end if;
      if fetches then
        next_read <= next_read + 1;
      end if;
      -- `fetches` is the last to be known: it only selects.
      if fetches then
        room   <= room + 1 when not write else room;
        stored <= stored - 1 when not write else stored;
      else
        room   <= room - 1 when write else room;
        stored <= stored + 1 when write else stored;
      end if;
      holds_entry <= fetches or (holds_entry and not taken);
      if rst then
        next_write  <= (others => '0');
        next_read   <= (others => '0');
        room        <= to_signed(2 ** depth_log2 - reserve - 1, room'length);
        stored      <= to_signed(-1, stored'length);
        holds_entry <= '0';
      end if;
    end if;
  end process control;

end architecture rtl;
