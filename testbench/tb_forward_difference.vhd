-- SPDX-License-Identifier: MIT
--
-- forward_difference, cut into slices, against its kernel, which is not: the value that every clock's commands bring,
-- at full speed and with random pauses.
--
-- The visible bits of the span part's I are expected latency + slices - 1 clocks after the command, in every clock from
-- the first span on. As many bits are visible as the channel has use for and the upper slice holds.

library ieee;
use ieee.numeric_std.all;
use ieee.std_logic_1164.all;

library std;
use std.textio.all;

library vunit_lib;
context vunit_lib.vunit_context;

library sheen;
use sheen.sheen_constants_pkg.all;
use sheen.sheen_pkg.all;

use work.vector_file_pkg.all;

entity tb_forward_difference is
  generic (
    runner_cfg    : string;
    width         : positive;
    slices        : positive;
    second_order  : boolean;
    family        : string;
    stall_percent : natural;
    count         : positive;
    seed          : positive;
    vector_folder : string
  );
end entity;

architecture tb of tb_forward_difference is

  constant latency      : positive := sheen.forward_difference'latency + slices - 1;
  constant clock_period : time := 10 ns;
  constant generics     : string :=
    "width=" & to_string(width) & ",second_order=" & to_string(second_order) & ",stall_percent=" &
    to_string(stall_percent);
  constant path         : string := vector_path(vector_folder, "forward_difference", generics);
  constant slice_width  : positive := (width + slices - 1) / slices;
  constant value_bits   : positive :=
    minimum(choose(second_order, colour_integer_bits, depth_bits), width - (slices - 1) * slice_width);

  constant idle : channel_command_t := (
    edge_part     => (others => '0'),
    span_part     => (others => '0'),
    push          => '0',
    push_address  => (others => '0'),
    fetch         => '0',
    fetch_address => (others => '0')
  );

  type expected_t is record
    valid  : std_ulogic;
    value  : std_ulogic_vector(value_bits - 1 downto 0);
    number : natural;  -- of the vector; 0: none
  end record;
  constant nothing : expected_t := ('0', (others => '0'), 0);
  type expected_vector_t is array (natural range <>) of expected_t;

  signal clk      : std_ulogic := '0';
  signal command  : channel_command_t := idle;
  signal present  : std_ulogic := '0';
  signal words    : word_vector_t(0 to choose(second_order, quadratic_words, linear_words) - 1) :=
    (others => (others => '0'));
  signal value    : std_ulogic_vector(value_bits - 1 downto 0);
  signal expected : expected_t := nothing;
  signal compared : natural := 0;

begin

  clk <= not clk after clock_period / 2;

  main : process
    file vectors    : text;
    variable vector : line;
    variable number : positive;

    impure function next_bits(bits : positive) return std_ulogic_vector is
      variable word : std_ulogic_vector(bits - 1 downto 0);
    begin
      read_word(vector, path, number, word);
      return word;
    end function;

    impure function next_bit return std_ulogic is
      variable word : std_ulogic;
    begin
      read_word(vector, path, number, word);
      return word;
    end function;

    impure function next_command return channel_command_t is
      variable read : channel_command_t := idle;
    begin
      read.edge_part.load   := next_bit;
      read.edge_part.linear := next_bit;
      read.edge_part.step   := next_bit;
      read.edge_part.carry  := next_bit;
      read.edge_part.depth  := next_bit;
      read.span_part.load   := next_bit;
      read.span_part.first  := next_bit;
      read.span_part.step   := next_bit;
      read.push             := next_bit;
      read.push_address     := unsigned(next_bits(span_queue_log2));
      read.fetch            := next_bit;
      read.fetch_address    := unsigned(next_bits(span_queue_log2));
      return read;
    end function;

    variable next_one : channel_command_t;
    variable started  : std_ulogic;
    variable next_i   : std_ulogic_vector(width - 1 downto 0);
  begin
    test_runner_setup(runner, runner_cfg);

    while test_suite loop
      if run("every_clock_shows_the_kernels_value") then
        open_vectors(vectors, path, "forward_difference", count, seed, generics);
        for vector_number in 1 to count loop
          number   := vector_number;
          read_vector(vectors, path, number, vector);
          next_one := next_command;
          command  <= next_one;
          present  <= next_one.edge_part.depth;
          for k in words'range loop
            words(k) <= next_bits(word_bits);
          end loop;
          started  := next_bit;
          next_i   := next_bits(width);
          expected <= (started, next_i(width - 1 downto width - value_bits), number);
          wait until rising_edge(clk);
        end loop;
        command  <= idle;
        expected <= nothing;
        wait until rising_edge(clk) and compared = count for (latency + 2) * clock_period;
        close_vectors(vectors, path, "forward_difference", count, compared);
      end if;
    end loop;

    test_runner_cleanup(runner);
  end process;

  check_values : process (clk)
    variable pipe : expected_vector_t(1 to latency) := (others => nothing);
  begin
    if rising_edge(clk) then
      if pipe(latency).valid = '1' then
        check_equal(value, pipe(latency).value, path & ":" & to_string(pipe(latency).number + 1) & ": value");
      end if;
      if pipe(latency).number > 0 then
        compared <= compared + 1;
      end if;
      pipe := expected & pipe(1 to latency - 1);
    end if;
  end process;

  dut : entity sheen.forward_difference
    generic map (
      width        => width,
      slices       => slices,
      second_order => second_order,
      value_bits   => value_bits,
      family       => family
    )
    port map (
      clk     => clk,
      command => command,
      present => present,
      words   => words,
      value   => value
    );

end architecture;
