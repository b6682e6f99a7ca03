-- SPDX-License-Identifier: MIT
--
-- colour_stage: channel values and a position in, one 64-bit output word out.
--
-- Colour is cut to its integer part (the host has folded +1/2 into I) and saturates to 0..255: the only place in the
-- datapath that saturates. Messages are put together here, so that they keep their place among the pixels. A position
-- whose x is 4095 would read as a message: such pixels are dropped (no image holds them).
--
--   bit   63    56 55    48 47    40 39     24 23  12 11   0
--         [ blue ] [green ] [ red  ] [ depth ] [ y  ] [ x  ]
--
-- Latency: 2 clocks (saturate, pack). Source: paper `quadratic`, section 5 (Round as Trunc of +1/2).
-- Model: hls/include/sheen/hls/colour_stage.hpp.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library sheen;
  use sheen.sheen_constants_pkg.all;
  use sheen.sheen_pkg.all;

entity colour_stage is
  port (
    clk : in std_ulogic;
    rst : in std_ulogic;

    description : in word_vector_t(0 to query_reply_words - 1);                     -- the data of a query's reply
    fragment    : in fragment_t;                                                    -- coordinates u12.0
    red         : in std_ulogic_vector(colour_integer_bits - 1 downto 0);           -- s10.0
    green       : in std_ulogic_vector(colour_integer_bits - 1 downto 0);           -- s10.0
    blue        : in std_ulogic_vector(colour_integer_bits - 1 downto 0);           -- s10.0
    depth       : in std_ulogic_vector(depth_bits - 1 downto 0);                    -- u16.0

    valid : out std_ulogic;
    fence : out std_ulogic;
    word  : out pixel_word_t
  );

  attribute latency : integer;
  attribute latency of colour_stage : entity is 2;
end entity colour_stage;

architecture rtl of colour_stage is

  subtype component_t is std_ulogic_vector(component_bits - 1 downto 0);

  function saturate (integer_part : std_ulogic_vector(colour_integer_bits - 1 downto 0)) return component_t is
  begin
    if integer_part(colour_integer_bits - 1) then
      return component_t'(others => '0');
    elsif integer_part(component_bits) then
      return component_t'(others => '1');
    end if;
    return integer_part(component_bits - 1 downto 0);
  end function saturate;

  -- The low fields of a message.
  function kind_and_x (kind : natural) return std_ulogic_vector is
  begin
    return std_ulogic_vector(to_unsigned(kind, coordinate_bits) & to_unsigned(message_x, coordinate_bits));
  end function kind_and_x;

  signal f         : fragment_t;
  signal red_8     : component_t;  -- u8.0
  signal green_8   : component_t;
  signal blue_8    : component_t;
  signal depth_now : std_ulogic_vector(depth_bits - 1 downto 0);

begin

  saturation : process (clk) is
  begin
    if rising_edge(clk) then
      f         <= fragment;
      f.valid   <= fragment.valid and (fragment.message or to_std_ulogic(fragment.x /= message_x));
      red_8     <= saturate(red);
      green_8   <= saturate(green);
      blue_8    <= saturate(blue);
      depth_now <= depth;
      if rst then
        f.valid <= '0';
      end if;
    end if;
  end process saturation;

  pack : process (clk) is
    variable code     : std_ulogic_vector(1 downto 0);
    variable is_fence : std_ulogic;
    variable header   : word_t;
  begin
    if rising_edge(clk) then
      code     := std_ulogic_vector(f.tail(1 downto 0));
      is_fence := not f.query and to_std_ulogic(code = "00");
      header   := std_ulogic_vector(f.tail(11 downto 4) & f.y & f.x);
      valid    <= f.valid;
      fence    <= f.message and is_fence;
      if not f.message then
        word <= blue_8 & green_8 & red_8 & depth_now & std_ulogic_vector(f.y & f.x);
      elsif f.query then
        word <= description(to_integer(f.x(1 downto 0))) & "000000" & std_ulogic_vector(f.x(1 downto 0))
                & kind_and_x(message_query);
      elsif is_fence then
        word <= header & "00000000"
                & kind_and_x(message_fence);
      else
        word <= header & "000000" & code
                & kind_and_x(message_error);
      end if;
      if rst then
        valid <= '0';
      end if;
    end if;
  end process pack;

end architecture rtl;
