-- SPDX-License-Identifier: MIT
--
-- sheen_pkg: the records that flow between units, and the few functions that they share.
--
-- Names and fields are those of hls/include/sheen/hls/types.hpp; widths come from sheen_constants_pkg, which is
-- generated from hls/include/sheen/hls/formats.hpp.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library sheen;
  use sheen.sheen_constants_pkg.all;

package sheen_pkg is

  subtype word_t is std_ulogic_vector(word_bits - 1 downto 0);
  subtype coordinate_t is unsigned(coordinate_bits - 1 downto 0);  -- u12.0, modulo 2**12
  subtype phase_t is unsigned(phase_bits - 1 downto 0);            -- u0.32
  subtype pixel_word_t is std_ulogic_vector(pixel_bits - 1 downto 0);
  type word_vector_t is array (natural range <>) of word_t;

  -- What the packet decoder hands over per job: a triangle, or a message that keeps its place between triangles.
  type job_t is record
    valid    : std_ulogic;
    message  : std_ulogic;                     -- no triangle: answer with a message word
    leftward : std_ulogic;                     -- triangle flags
    linear   : std_ulogic;
    depth    : std_ulogic;
    log      : std_ulogic_vector(1 downto 0);  -- number of log channels
    code     : std_ulogic_vector(1 downto 0);  -- message: error code, 0 for the answer to a fence or a query
    header   : word_t;                         -- message: the header it answers
  end record job_t;

  -- The geometry fields of a triangle packet.
  type geometry_t is record
    x             : coordinate_t;
    y             : coordinate_t;
    rows_above    : coordinate_t;
    rows_below    : coordinate_t;
    kappa         : coordinate_t;
    length        : coordinate_t;
    m             : coordinate_t;
    length_reload : coordinate_t;
    m_below       : coordinate_t;
    long_phase    : phase_t;
    long_step     : phase_t;
    upper_phase   : phase_t;
    upper_step    : phase_t;
    lower_phase   : phase_t;
    lower_step    : phase_t;
  end record geometry_t;

  -- A span, or a message on its way through the span queue: header bits 11..0 in x and 23..12 in y; length is 4 for a
  -- query (whose x then counts the words of the reply), {opcode, 00, code} for the one word of an error or fence echo.
  type span_t is record
    x        : coordinate_t;
    y        : coordinate_t;
    length   : coordinate_t;
    single   : std_ulogic;  -- one word long
    leftward : std_ulogic;  -- x decreases
    first    : std_ulogic;  -- first span of its triangle: the span part takes over the triangle's constants
    message  : std_ulogic;
  end record span_t;

  -- Commands of the edge walker to the start-edge part of every forward difference. A carry comes in the clock after
  -- its step, the first step not before the second clock after a load.
  type edge_command_t is record
    load   : std_ulogic;  -- take over the six words
    linear : std_ulogic;  -- with load: h, dD, dE are 0
    depth  : std_ulogic;  -- with load: the packet has a depth channel (else its value is 0)
    step   : std_ulogic;  -- one row down: I += E, E += dE, D += dD
    carry  : std_ulogic;  -- with step, one pixel along instead: I += D, D += h, E += dD
  end record edge_command_t;

  -- Commands of the span walker to the span part of every forward difference.
  type span_command_t is record
    load  : std_ulogic;  -- start the span at the head of the queue
    first : std_ulogic;  -- with load: take over h (and a linear channel's D)
    step  : std_ulogic;  -- I += D, D += h
  end record span_command_t;

  subtype span_address_t is unsigned(span_queue_log2 - 1 downto 0);

  -- All that a channel is told in one clock.
  type channel_command_t is record
    edge_part     : edge_command_t;
    span_part     : span_command_t;
    push          : std_ulogic;      -- write {I, D} into the channel's share of the span queue
    push_address  : span_address_t;
    fetch         : std_ulogic;      -- move the entry to the queue's head
    fetch_address : span_address_t;
  end record channel_command_t;

  -- A pixel position or a message word on its way to the colour stage.
  type fragment_t is record
    valid   : std_ulogic;
    message : std_ulogic;
    query   : std_ulogic;                     -- message: word x of a query reply
    log     : std_ulogic_vector(1 downto 0);  -- pixel: log channels of its triangle
    x       : coordinate_t;
    y       : coordinate_t;
    tail    : coordinate_t;  -- message: {opcode, 00, code}
  end record fragment_t;

  -- A word of a power table on its way into the bank that is not read.
  type table_write_t is record
    valid   : std_ulogic;
    bank    : std_ulogic;
    address : unsigned(power_word_bits - 1 downto 0);
    data    : word_t;                 -- four entries u8.0, the first in the low bits
  end record table_write_t;

  constant no_table_write : table_write_t := (valid => '0', bank => '0', address => (others => '0'),
                                              data => (others => '0'));

  subtype ambient_t is unsigned(component_bits + colour_sum_fraction_bits - 1 downto 0);                   -- u8.4
  subtype diffuse_t is std_ulogic_vector(colour_integer_bits + colour_sum_fraction_bits - 1 downto 0);     -- s10.4
  subtype log_t is signed(log_integer_bits + exp2_address_bits - 1 downto 0);                              -- s8.6
  type log_vector_t is array (natural range <>) of log_t;

  -- What a material packet says, cut to what the datapath keeps.
  type material_t is record
    red   : ambient_t;
    green : ambient_t;
    blue  : ambient_t;
    power : std_ulogic_vector(max_log_channels - 1 downto 0);  -- bit k: log channel k is a cosine, for power_rom
  end record material_t;

  constant no_material : material_t := (red => (others => '0'), green => (others => '0'), blue => (others => '0'),
                                        power => (others => '0'));

  constant span_width : positive := 3 * coordinate_bits + 4;

  function to_vector (span : span_t) return std_ulogic_vector;
  function to_span (vector : std_ulogic_vector) return span_t;

  -- a + b + carry with the carry-out on top: one adder of one bit more, where a sum of three terms would take two.
  function add_with_carry (a : unsigned; b : unsigned; carry : std_ulogic) return unsigned;

  -- The geometry fields out of the first ten words of a triangle's payload.
  function to_geometry (words : word_vector_t) return geometry_t;

  function to_std_ulogic (condition : boolean) return std_ulogic;

  -- a if condition, else b; for constants.
  function choose (condition : boolean; a : natural; b : natural) return natural;

end package sheen_pkg;

package body sheen_pkg is

  function to_vector (span : span_t) return std_ulogic_vector is
  begin
    return span.message & span.first & span.leftward & span.single & std_ulogic_vector(span.length)
           & std_ulogic_vector(span.y) & std_ulogic_vector(span.x);
  end function to_vector;

  function to_span (vector : std_ulogic_vector) return span_t is
    alias v       : std_ulogic_vector(span_width - 1 downto 0) is vector;
    variable span : span_t;
  begin
    span.x        := unsigned(v(coordinate_bits - 1 downto 0));
    span.y        := unsigned(v(2 * coordinate_bits - 1 downto coordinate_bits));
    span.length   := unsigned(v(3 * coordinate_bits - 1 downto 2 * coordinate_bits));
    span.single   := v(3 * coordinate_bits);
    span.leftward := v(3 * coordinate_bits + 1);
    span.first    := v(3 * coordinate_bits + 2);
    span.message  := v(3 * coordinate_bits + 3);
    return span;
  end function to_span;

  function add_with_carry (a : unsigned; b : unsigned; carry : std_ulogic) return unsigned is
    variable sum : unsigned(a'length + 1 downto 0);
  begin
    sum := unsigned'('0' & a & '1') + unsigned'('0' & b & carry);
    return sum(a'length + 1 downto 1);
  end function add_with_carry;

  function to_geometry (words : word_vector_t) return geometry_t is
    variable packed   : std_ulogic_vector(geometry_words * word_bits - 1 downto 0);
    variable geometry : geometry_t;

    function field (source : std_ulogic_vector; index : natural) return coordinate_t is
    begin
      return unsigned(source((index + 1) * coordinate_bits - 1 downto index * coordinate_bits));
    end function field;
  begin
    packed := words(3) & words(2) & words(1) & words(0);
    geometry.x             := field(packed, 0);
    geometry.y             := field(packed, 1);
    geometry.rows_above    := field(packed, 2);
    geometry.rows_below    := field(packed, 3);
    geometry.kappa         := field(packed, 4);
    geometry.length        := field(packed, 5);
    geometry.m             := field(packed, 6);
    geometry.length_reload := field(packed, 7);
    geometry.m_below       := field(packed, 8);
    geometry.long_phase    := unsigned(words(4));
    geometry.long_step     := unsigned(words(5));
    geometry.upper_phase   := unsigned(words(6));
    geometry.upper_step    := unsigned(words(7));
    geometry.lower_phase   := unsigned(words(8));
    geometry.lower_step    := unsigned(words(9));
    return geometry;
  end function to_geometry;

  function to_std_ulogic (condition : boolean) return std_ulogic is
  begin
    if condition then
      return '1';
    end if;
    return '0';
  end function to_std_ulogic;

  function choose (condition : boolean; a : natural; b : natural) return natural is
  begin
    if condition then
      return a;
    end if;
    return b;
  end function choose;

end package body sheen_pkg;
