# SPDX-License-Identifier: MIT
"""The harness around a core that is built out of context: three pins, whatever the core's ports.

          pin -> shift register -> every input bit of the core
                                   every output bit -> register -> xor into a shift register -> fold

The core's inputs come from registers and its outputs go into registers, so paths through its ports count as paths
between registers. The harness itself has at most one LUT between two of them.
"""

import re

PORT = re.compile(r"(input|output)\s+(?:\[(\d+):0\]\s*)?(\w+)")


def ports(verilog, entity):
    """[(direction, name, bits)] of a module that GHDL wrote, the clock left out."""
    header = re.search(rf"^module {entity}\s*\((.*?)\);", verilog, re.MULTILINE | re.DOTALL).group(1)
    found = [(direction, name, int(high or 0) + 1) for direction, high, name in PORT.findall(header)]
    return [port for port in found if port[1] != "clk"]


def harness(entity, core_ports):
    """Verilog text of module `harness` around the black box `entity`."""
    declarations = ", ".join(f"{direction} [{bits - 1}:0] {name}" for direction, name, bits in core_ports)
    connections = []
    used = {"input": 0, "output": 0}
    for direction, name, bits in core_ports:
        bus = "spread" if direction == "input" else "result"
        low = used[direction]
        connections.append(f".{name}({bus}[{low + bits - 1}:{low}])")
        used[direction] += bits
    return f"""(* blackbox *) module {entity}(input clk, {declarations});
endmodule

module harness(input clk, input pin, output fold);
  reg [{used["input"] - 1}:0] spread;
  wire [{used["output"] - 1}:0] result;
  reg [{used["output"] - 1}:0] held, folded;
  assign fold = folded[{used["output"] - 1}];
  always @(posedge clk) begin
    spread <= {{spread, pin}};
    held   <= result;
    folded <= held ^ {{folded, 1'b0}};
  end
  {entity} core(.clk(clk), {", ".join(connections)});
endmodule
"""
