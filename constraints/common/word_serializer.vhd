-- SPDX-License-Identifier: MIT
--
-- word_serializer: the words of a pixel stream into bytes, the lowest first.
--
-- A word is taken when the last byte of the one before has gone; the stream waits meanwhile.

library ieee;
  use ieee.std_logic_1164.all;

library sheen;
  use sheen.sheen_constants_pkg.all;
  use sheen.sheen_pkg.all;

entity word_serializer is
  port (
    clk : in std_ulogic;
    rst : in std_ulogic;

    s_axis_tdata  : in pixel_word_t;
    s_axis_tvalid : in std_ulogic;
    s_axis_tready : out std_ulogic;

    byte_valid : out std_ulogic;
    byte_ready : in std_ulogic;
    octet       : out std_ulogic_vector(7 downto 0)
  );
end entity word_serializer;

architecture rtl of word_serializer is

  constant bytes : positive := pixel_bits / 8;

  signal shift : pixel_word_t;
  signal left  : natural range 0 to bytes := 0;  -- bytes that have not gone

begin

  s_axis_tready <= to_std_ulogic(left = 0);
  byte_valid    <= to_std_ulogic(left /= 0);
  octet          <= shift(7 downto 0);

  serialize : process (clk) is
  begin
    if rising_edge(clk) then
      if left = 0 then
        if s_axis_tvalid then
          shift <= s_axis_tdata;
          left  <= bytes;
        end if;
      elsif byte_ready then
        shift <= "00000000" & shift(pixel_bits - 1 downto 8);
        left  <= left - 1;
      end if;
      if rst then
        left <= 0;
      end if;
    end if;
  end process serialize;

end architecture rtl;
