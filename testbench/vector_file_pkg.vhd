-- SPDX-License-Identifier: MIT
--
-- Reading the vector files that tests/vectors/make_vectors_* write (format: tests/vectors/vector_file.hpp).
--
-- A file that is missing, empty, of another unit, count, seed or configuration, too short or too long fails the bench;
-- the message names the file, the line and what was expected.

library ieee;
use ieee.std_logic_1164.all;

library std;
use std.textio.all;

package vector_file_pkg is

  -- FOLDER/UNIT.GENERICS.txt
  impure function vector_path(folder, unit, generics : string) return string;

  -- Opens the file and compares its first line with the one that these arguments demand.
  procedure open_vectors(
    file vectors  : text;
    path          : in string;
    unit          : in string;
    count         : in positive;
    seed          : in positive;
    generics      : in string
  );

  -- The next vector's line; `number` counts vectors from 1, so the vector stands on line number + 1.
  procedure read_vector(file vectors : text; path : in string; number : in positive; vector : inout line);

  -- The next hexadecimal word of a vector, as many bits as `word` has.
  procedure read_word(vector : inout line; path : in string; number : in positive; word : out std_ulogic_vector);
  procedure read_word(vector : inout line; path : in string; number : in positive; word : out std_ulogic);

  -- Fails if a line is left; prints `UNIT: N vectors compared`.
  procedure close_vectors(
    file vectors : text;
    path         : in string;
    unit         : in string;
    count        : in positive;
    compared     : in natural
  );

end package;

package body vector_file_pkg is

  impure function vector_path(folder, unit, generics : string) return string is
  begin
    return folder & "/" & unit & "." & generics & ".txt";
  end function;

  procedure open_vectors(
    file vectors  : text;
    path          : in string;
    unit          : in string;
    count         : in positive;
    seed          : in positive;
    generics      : in string
  ) is
    constant expected : string :=
      unit & " count=" & to_string(count) & " seed=" & to_string(seed) & " " & generics;
    variable status : file_open_status;
    variable header : line;
  begin
    file_open(status, vectors, path, read_mode);
    assert status = open_ok
      report path & ": cannot be read; make_vectors_" & unit & " writes it"
      severity failure;
    assert not endfile(vectors)
      report path & ": is empty; expected the header '" & expected & "'"
      severity failure;
    readline(vectors, header);
    assert header.all = expected
      report path & ":1: header is '" & header.all & "', expected '" & expected & "'"
      severity failure;
    deallocate(header);
  end procedure;

  procedure read_vector(file vectors : text; path : in string; number : in positive; vector : inout line) is
  begin
    assert not endfile(vectors)
      report path & ":" & to_string(number + 1) & ": the file ends before vector " & to_string(number)
      severity failure;
    readline(vectors, vector);
  end procedure;

  procedure read_word(vector : inout line; path : in string; number : in positive; word : out std_ulogic_vector) is
    variable good : boolean;
  begin
    hread(vector, word, good);
    assert good
      report path & ":" & to_string(number + 1) & ": expected a hexadecimal word of " & to_string(word'length) & " bits"
      severity failure;
  end procedure;

  procedure read_word(vector : inout line; path : in string; number : in positive; word : out std_ulogic) is
    variable bits : std_ulogic_vector(0 downto 0);
  begin
    read_word(vector, path, number, bits);
    word := bits(0);
  end procedure;

  procedure close_vectors(
    file vectors : text;
    path         : in string;
    unit         : in string;
    count        : in positive;
    compared     : in natural
  ) is
    variable summary : line;
  begin
    assert endfile(vectors)
      report path & ":" & to_string(count + 2) & ": the file goes on after its " & to_string(count) & " vectors"
      severity failure;
    assert compared = count
      report path & ": " & to_string(compared) & " vectors compared, expected " & to_string(count)
      severity failure;
    file_close(vectors);
    write(summary, unit & ": " & to_string(compared) & " vectors compared");
    writeline(output, summary);
  end procedure;

end package body;
