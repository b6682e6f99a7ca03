-- SPDX-License-Identifier: MIT
--
-- highlight_stage: what the colour and log channels add up to, max(0, diffuse) + ambient + sum of the highlights.
--
--   diffuse --> max(0, .) + ambient ---------------- delay ----------+
--   log k ----> exp2_rom or power_rom (material's kinds) --> sum --> + --> colour_stage
--
-- A triangle without log channels passes as it is (its ambient is in its colour channels): max(0, colour) is what
-- colour_stage would have made of it.
--
-- Materials keep their place among the pixels. The decoder holds a new material, or fills the power bank that is not
-- read, and sends a message of its packet's opcode through the span queue; when it arrives here, the material is taken
-- over, or the banks change roles, and the message ends. `material_applied` and `table_applied` tell the decoder, which
-- holds back the next one.
--
-- Formats: diffuse s10.4, ambient u8.4, log s8.6 (z, or 16*cos), highlights u8.4; sums are exact.
-- Latency: 4 + log_channels clocks (tables 4, their sum log_channels - 1, the whole sum 1).
-- Kernel: hls/include/sheen/hls/highlight_stage.hpp, equal to the bit.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library sheen;
  use sheen.sheen_constants_pkg.all;
  use sheen.sheen_pkg.all;

entity highlight_stage is
  generic (
    log_channels : positive range 1 to max_log_channels := 1;
    -- Each log channel has a power_rom beside its exp2_rom.
    has_power : boolean := true
  );
  port (
    clk : in std_ulogic;
    rst : in std_ulogic;

    fragment : in fragment_t;
    red      : in diffuse_t;                                   -- s10.4
    green    : in diffuse_t;
    blue     : in diffuse_t;
    depth    : in std_ulogic_vector(depth_bits - 1 downto 0);  -- u16.0
    logs     : in log_vector_t(0 to log_channels - 1);         -- s8.6

    pending          : in material_t;                          -- the material that the decoder holds
    write            : in table_write_t;                       -- into the power bank that is not read
    material_applied : out std_ulogic;
    table_applied    : out std_ulogic;

    fragment_out : out fragment_t;
    red_out      : out std_ulogic_vector(colour_integer_bits - 1 downto 0);  -- s10.0, never negative
    green_out    : out std_ulogic_vector(colour_integer_bits - 1 downto 0);
    blue_out     : out std_ulogic_vector(colour_integer_bits - 1 downto 0);
    depth_out    : out std_ulogic_vector(depth_bits - 1 downto 0)
  );
end entity highlight_stage;

architecture rtl of highlight_stage is

  constant rom_latency : positive := 4;
  constant latency     : positive := rom_latency + log_channels;
  constant base_bits   : positive := colour_integer_bits + colour_sum_fraction_bits;

  subtype value_t is unsigned(component_bits + colour_sum_fraction_bits - 1 downto 0);  -- u8.4
  subtype base_t is unsigned(base_bits - 1 downto 0);                                   -- u10.4
  type value_vector_t is array (natural range <>) of value_t;

  -- A pixel on its way beside the tables.
  type lane_t is record
    fragment : fragment_t;
    red      : base_t;      -- max(0, diffuse) + ambient
    green    : base_t;
    blue     : base_t;
    depth    : std_ulogic_vector(depth_bits - 1 downto 0);
    power    : std_ulogic_vector(max_log_channels - 1 downto 0);  -- its material's kinds
  end record lane_t;

  type lane_vector_t is array (natural range <>) of lane_t;

  -- max(0, diffuse), and the material's ambient where the triangle has log channels.
  function base (diffuse : diffuse_t; lit : std_ulogic; ambient : ambient_t) return base_t is
    variable positive_part : base_t;
    variable added         : value_t;
  begin
    positive_part := unsigned(diffuse) and not (base_t'range => diffuse(diffuse'high));
    added         := unsigned(ambient) and (value_t'range => lit);
    return positive_part + added;
  end function base;

  -- The whole sum's integer part, at most 511 so that it stays positive; colour_stage saturates it.
  function whole (base_sum : base_t; highlights : base_t) return std_ulogic_vector is
    variable sum  : unsigned(base_bits downto 0);
    variable over : std_ulogic;
  begin
    sum  := resize(base_sum, base_bits + 1) + highlights;
    over := or sum(base_bits downto value_t'length);
    return '0' & over & std_ulogic_vector(sum(value_t'high downto colour_sum_fraction_bits));
  end function whole;

  signal material    : material_t;
  signal bank        : std_ulogic;
  signal lanes       : lane_vector_t(1 to latency - 1);
  signal values      : value_vector_t(0 to log_channels - 1);
  signal highlights  : value_vector_t(0 to log_channels - 1);
  signal highlight_sum : base_t;
  signal takes_material : std_ulogic;
  signal takes_table    : std_ulogic;

begin

  recognise : process (all) is
    variable applies : std_ulogic;
    variable opcode  : unsigned(7 downto 0);
  begin
    opcode         := fragment.tail(11 downto 4);
    applies        := fragment.valid and fragment.message and not fragment.query
                      and not (fragment.tail(1) or fragment.tail(0));
    takes_material <= applies and to_std_ulogic(opcode = opcode_material);
    takes_table    <= applies and to_std_ulogic(opcode = opcode_table);
  end process recognise;

  take_over : process (clk) is
  begin
    if rising_edge(clk) then
      material_applied <= takes_material;
      table_applied    <= takes_table;
      bank             <= bank xor takes_table;
      if takes_material then
        material <= pending;
      end if;
      if rst then
        material_applied <= '0';
        table_applied    <= '0';
        bank             <= '0';
        material         <= no_material;
      end if;
    end if;
  end process take_over;

  delay : process (clk) is
    variable lit : std_ulogic;
  begin
    if rising_edge(clk) then
      lit := or fragment.log;
      lanes(1).fragment <= fragment;
      lanes(1).fragment.valid <= fragment.valid and not takes_material and not takes_table;
      lanes(1).red   <= base(red, lit, material.red);
      lanes(1).green <= base(green, lit, material.green);
      lanes(1).blue  <= base(blue, lit, material.blue);
      lanes(1).depth <= depth;
      lanes(1).power <= material.power;
      for k in 2 to latency - 1 loop
        lanes(k) <= lanes(k - 1);
      end loop;
      if rst then
        for k in 1 to latency - 1 loop
          lanes(k).fragment.valid <= '0';
        end loop;
      end if;
    end if;
  end process delay;

  log_channel : for k in 0 to log_channels - 1 generate
    signal exp2_value  : value_t;
    signal power_value : value_t;
    signal present     : std_ulogic;
  begin

    exponential : entity sheen.exp2_rom
      port map (
        clk   => clk,
        z     => logs(k),
        value => exp2_value
      );

    table : if has_power generate

      power : entity sheen.power_rom
        port map (
          clk   => clk,
          write => write,
          bank  => bank,
          t     => logs(k),
          value => power_value
        );

      values(k) <= power_value when lanes(rom_latency).power(k) else exp2_value;

    else generate

      values(k) <= exp2_value;

    end generate table;

    -- Nothing where the pixel's triangle doesn't have this channel.
    present       <= to_std_ulogic(unsigned(lanes(rom_latency).fragment.log) > k);
    highlights(k) <= values(k) and (value_t'range => present);

  end generate log_channel;

  -- The sum of the highlights.
  one : if log_channels = 1 generate

    highlight_sum <= resize(highlights(0), base_bits);

  end generate one;

  two : if log_channels = 2 generate

    add : process (clk) is
    begin
      if rising_edge(clk) then
        highlight_sum <= resize(highlights(0), base_bits) + highlights(1);
      end if;
    end process add;

  end generate two;

  three : if log_channels = 3 generate
    signal sum  : base_t;
    signal late : value_t;
  begin

    add : process (clk) is
    begin
      if rising_edge(clk) then
        sum           <= resize(highlights(0), base_bits) + highlights(1);
        late          <= highlights(2);
        highlight_sum <= sum + late;
      end if;
    end process add;

  end generate three;

  add_all : process (clk) is
  begin
    if rising_edge(clk) then
      fragment_out <= lanes(latency - 1).fragment;
      red_out      <= whole(lanes(latency - 1).red, highlight_sum);
      green_out    <= whole(lanes(latency - 1).green, highlight_sum);
      blue_out     <= whole(lanes(latency - 1).blue, highlight_sum);
      depth_out    <= lanes(latency - 1).depth;
      if rst then
        fragment_out.valid <= '0';
      end if;
    end if;
  end process add_all;

end architecture rtl;
