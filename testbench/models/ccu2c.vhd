-- SPDX-License-Identifier: MIT
--
-- CCU2C, the carry cell of ECP5, for simulation and analysis; synthesis takes the family's own cell.
--
-- Two bits. Of each, function(D, C, B, A) xor carry is S; where the function is 1, the carry passes, where it is 0, its
-- value for (0, 0, B, A) is the new carry. Only INJECT1_x = "NO" is modelled. Written after yosys' ecp5/cells_sim.v.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

entity ccu2c is
  generic (
    init0     : std_logic_vector(15 downto 0);
    init1     : std_logic_vector(15 downto 0);
    inject1_0 : string;
    inject1_1 : string
  );
  port (
    cin  : in std_ulogic;
    a0   : in std_ulogic;
    b0   : in std_ulogic;
    c0   : in std_ulogic;
    d0   : in std_ulogic;
    a1   : in std_ulogic;
    b1   : in std_ulogic;
    c1   : in std_ulogic;
    d1   : in std_ulogic;
    s0   : out std_ulogic;
    s1   : out std_ulogic;
    cout : out std_ulogic
  );
end entity ccu2c;

architecture model of ccu2c is

  signal carry : std_ulogic;

  -- The function's value; unknown inputs count as 0, since the value that a load overwrites may be unknown.
  function look_up (init : std_logic_vector(15 downto 0); inputs : std_ulogic_vector(3 downto 0)) return std_ulogic is
    variable known : unsigned(3 downto 0) := (others => '0');
  begin
    for k in known'range loop
      if inputs(k) = '1' then
        known(k) := '1';
      end if;
    end loop;
    return init(to_integer(known));
  end function look_up;

  function next_carry (passes : std_ulogic; before : std_ulogic; made : std_ulogic) return std_ulogic is
  begin
    return (passes and before) or (not passes and made);
  end function next_carry;

begin

  assert inject1_0 = "NO" and inject1_1 = "NO"
    report "ccu2c: INJECT1_0 and INJECT1_1 must be NO"
    severity failure;

  carry <= next_carry(look_up(init0, d0 & c0 & b0 & a0), cin, look_up(init0, "00" & b0 & a0));
  cout  <= next_carry(look_up(init1, d1 & c1 & b1 & a1), carry, look_up(init1, "00" & b1 & a1));
  s0    <= look_up(init0, d0 & c0 & b0 & a0) xor cin;
  s1    <= look_up(init1, d1 & c1 & b1 & a1) xor carry;

end architecture model;
