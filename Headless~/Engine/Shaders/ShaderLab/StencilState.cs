using System;
using System.Collections.Generic;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>"Stencil { Ref 1 Comp Equal Pass Keep }"; one state for front and back faces.</summary>
    sealed class StencilState
    {
        static readonly string[] Operations = { "Keep", "Zero", "Replace", "IncrSat", "DecrSat", "Invert", "IncrWrap", "DecrWrap" };

        // By CompareFunction: unlike depth, stencil values are compared as they are.
        static readonly DeviceCompare[] DeviceCompares =
        {
            DeviceCompare.Always, DeviceCompare.Never, DeviceCompare.Less, DeviceCompare.Equal, DeviceCompare.LessEqual,
            DeviceCompare.Greater, DeviceCompare.NotEqual, DeviceCompare.GreaterEqual, DeviceCompare.Always,
        };

        StateValue reference, readMask = new StateValue(255), writeMask = new StateValue(255), compare = new StateValue(8), pass, fail, depthFail;

        /// <param name="choice">Reads one of some words, or a property in brackets.</param>
        /// <param name="number">The same for numbers.</param>
        public static StencilState Read(ShaderLabReader reader, Func<ShaderLabReader, string[], StateValue> choice, Func<ShaderLabReader,
            StateValue> number, List<string> notes)
        {
            var state = new StencilState();
            reader.Expect('{');
            while (!reader.TryReadSymbol('}'))
            {
                int line = reader.Line;
                string command = reader.ReadWord("a command of Stencil");
                switch (command.ToLowerInvariant())
                {
                    case "ref": state.reference = number(reader); break;
                    case "readmask": state.readMask = number(reader); break;
                    case "writemask": state.writeMask = number(reader); break;
                    case "comp": case "compfront": state.compare = choice(reader, RenderState.Compares); break;
                    case "pass": case "passfront": state.pass = choice(reader, Operations); break;
                    case "fail": case "failfront": state.fail = choice(reader, Operations); break;
                    case "zfail": case "zfailfront": state.depthFail = choice(reader, Operations); break;
                    case "compback":
                        choice(reader, RenderState.Compares);
                        notes.Add($"line {line}: {command} is left out; back faces take the state of front faces");
                        break;
                    case "passback": case "failback": case "zfailback":
                        choice(reader, Operations);
                        notes.Add($"line {line}: {command} is left out; back faces take the state of front faces");
                        break;
                    default: throw reader.Error($"'{command}' is not a command of Stencil");
                }
            }
            return state;
        }

        public DeviceStencil Resolve(Func<string, float> properties) => new DeviceStencil
        {
            Enabled = true,
            Reference = (byte)reference.ResolveInt(properties), ReadMask = (byte)readMask.ResolveInt(properties),
                WriteMask = (byte)writeMask.ResolveInt(properties),
            Compare = DeviceCompares[Math.Clamp(compare.ResolveInt(properties), 0, DeviceCompares.Length - 1)],
            Pass = Operation(pass, properties), Fail = Operation(fail, properties), DepthFail = Operation(depthFail, properties),
        };

        static DeviceStencilOp Operation(StateValue value, Func<string, float> properties)
            => (DeviceStencilOp)Math.Clamp(value.ResolveInt(properties), 0, 7);
    }
}
