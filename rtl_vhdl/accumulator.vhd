-- SPDX-License-Identifier: MIT
--
-- accumulator: one slice of a register that takes over a start value or adds, with its carry kept for the next slice.
--
--   load    value <= start                             else    {carry_out, value} <= value + addend + carry_in
--           carry_out <= 0
--
-- both in a clock with `enable`. The architecture's first half says just that. For `family` = "ecp5" the same stands in
-- carry cells, where the four inputs of a bit hold the choice of a load as well, so that no multiplexer follows the
-- adder: yosys by itself would spend a LUT a bit on it. `make formal` proves the two equal.
--
-- Number format: any, modulo 2**width. Latency: 1 clock. Source: Sheen's own.
-- Model: hls/include/sheen/hls/forward_difference.hpp, whose additions it does slice by slice.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library sheen;
  use sheen.sheen_pkg.all;

entity accumulator is
  generic (
    width  : positive := 16;
    family : string   := "plain"  -- or "ecp5"
  );
  port (
    clk : in std_ulogic;

    enable   : in std_ulogic;
    load     : in std_ulogic;  -- with enable
    start    : in unsigned(width - 1 downto 0);
    addend   : in unsigned(width - 1 downto 0);
    carry_in : in std_ulogic;

    value     : out unsigned(width - 1 downto 0);
    carry_out : out std_ulogic
  );

  attribute latency : integer;
  attribute latency of accumulator : entity is 1;
end entity accumulator;

architecture rtl of accumulator is

  signal accumulated : unsigned(width - 1 downto 0);
  signal next_value  : unsigned(width downto 0);

begin

  assert family = "plain" or family = "ecp5"
    report "accumulator: family is " & family & ", it must be plain or ecp5"
    severity failure;

  value <= accumulated;

  keep : process (clk) is
  begin
    if rising_edge(clk) then
      if enable then
        accumulated <= next_value(width - 1 downto 0);
        carry_out   <= next_value(width);
      end if;
    end if;
  end process keep;

  choose_family : if family = "ecp5" generate

    -- Two bits. The exclusive or of a function of A, B, C, D and of the carry is S; where the function is 1, the carry
    -- passes, where it is 0, its value for the same A, B and C = D = 0 is the new carry.
    -- Its names are Lattice's, in capitals.
    -- vsg_off component_008 component_012 generic_007 port_010
    component CCU2C is
      generic (
        INIT0     : std_logic_vector(15 downto 0);
        INIT1     : std_logic_vector(15 downto 0);
        INJECT1_0 : string;
        INJECT1_1 : string
      );
      port (
        CIN  : in std_ulogic;
        A0   : in std_ulogic;
        B0   : in std_ulogic;
        C0   : in std_ulogic;
        D0   : in std_ulogic;
        A1   : in std_ulogic;
        B1   : in std_ulogic;
        C1   : in std_ulogic;
        D1   : in std_ulogic;
        S0   : out std_ulogic;
        S1   : out std_ulogic;
        COUT : out std_ulogic
      );
    end component CCU2C;
    -- vsg_on component_008 component_012 generic_007 port_010

    -- Bit 0 makes the carry-in, bits 1 to width add or load, bit width + 1 shows the carry-out.
    constant cells : positive := (width + 3) / 2;
    subtype bits_t is std_ulogic_vector(2 * cells - 1 downto 0);
    subtype function_t is std_logic_vector(15 downto 0);
    constant makes_carry   : function_t := x"0002";  -- 0, as D is 1; carry A and not B
    constant adds_or_loads : function_t := x"DE12";  -- D when B else A xor C; carry A and not B
    constant shows_carry   : function_t := x"0000";

    function function_of (bit_number : natural) return function_t is
    begin
      if bit_number = 0 then
        return makes_carry;
      elsif bit_number <= width then
        return adds_or_loads;
      end if;
      return shows_carry;
    end function function_of;

    constant unused : std_ulogic_vector(2 * cells - 1 downto width + 1) := (others => '0');

    signal a     : bits_t;
    signal c     : bits_t;
    signal d     : bits_t;
    signal s     : bits_t;
    signal chain : std_ulogic_vector(cells downto 0);
  begin

    a        <= unused & std_ulogic_vector(accumulated) & carry_in;
    c        <= unused & std_ulogic_vector(addend) & '0';
    d        <= unused & std_ulogic_vector(start) & '1';
    chain(0) <= '0';

    pair : for n in 0 to cells - 1 generate

      -- vsg_off instantiation_009 generic_map_002 port_map_002
      bits : component CCU2C
        generic map (
          INIT0     => function_of(2 * n),
          INIT1     => function_of(2 * n + 1),
          INJECT1_0 => "NO",
          INJECT1_1 => "NO"
        )
        port map (
          CIN  => chain(n),
          A0   => a(2 * n),
          B0   => load,
          C0   => c(2 * n),
          D0   => d(2 * n),
          A1   => a(2 * n + 1),
          B1   => load,
          C1   => c(2 * n + 1),
          D1   => d(2 * n + 1),
          S0   => s(2 * n),
          S1   => s(2 * n + 1),
          COUT => chain(n + 1)
        );
    -- vsg_on instantiation_009 generic_map_002 port_map_002

    end generate pair;

    next_value <= unsigned(s(width + 1 downto 1));

  else generate

    next_value <= '0' & start when load else add_with_carry(accumulated, addend, carry_in);

  end generate choose_family;

end architecture rtl;
