#!/usr/bin/env python3
"""Writes Vk.Generated.cs beside this file: the commands listed here and every type they reach, from Khronos's registry.

    python3 generate.py [/usr/share/vulkan/registry/vk.xml]      (Debian: libvulkan-dev)

Python's standard library only. What the host does not call is not written; to call more, extend a list and run again.
"""
import pathlib
import re
import sys
import xml.etree.ElementTree as ET

GLOBAL = """vkCreateInstance vkEnumerateInstanceLayerProperties vkEnumerateInstanceExtensionProperties""".split()

INSTANCE = """vkDestroyInstance vkEnumeratePhysicalDevices vkGetPhysicalDeviceProperties2 vkGetPhysicalDeviceFeatures2
vkGetPhysicalDeviceMemoryProperties vkGetPhysicalDeviceQueueFamilyProperties vkGetPhysicalDeviceFormatProperties
vkEnumerateDeviceExtensionProperties vkCreateDevice vkGetDeviceProcAddr
vkCreateDebugUtilsMessengerEXT vkDestroyDebugUtilsMessengerEXT""".split()

DEVICE = """vkDestroyDevice vkGetDeviceQueue vkQueueSubmit2 vkDeviceWaitIdle vkSetDebugUtilsObjectNameEXT
vkAllocateMemory vkFreeMemory vkMapMemory
vkCreateBuffer vkDestroyBuffer vkGetBufferMemoryRequirements vkBindBufferMemory vkCreateBufferView vkDestroyBufferView
vkCreateImage vkDestroyImage vkGetImageMemoryRequirements vkBindImageMemory vkCreateImageView vkDestroyImageView
vkCreateSampler vkDestroySampler
vkCreateShaderModule vkDestroyShaderModule vkCreatePipelineCache vkDestroyPipelineCache vkGetPipelineCacheData
vkCreateDescriptorSetLayout vkDestroyDescriptorSetLayout vkCreatePipelineLayout vkDestroyPipelineLayout
vkCreateComputePipelines vkCreateGraphicsPipelines vkDestroyPipeline
vkCreateQueryPool vkDestroyQueryPool vkResetQueryPool vkGetQueryPoolResults
vkCreateSemaphore vkDestroySemaphore vkWaitSemaphores vkGetSemaphoreCounterValue
vkCreateCommandPool vkDestroyCommandPool vkResetCommandPool vkAllocateCommandBuffers vkBeginCommandBuffer vkEndCommandBuffer
vkCmdBindPipeline vkCmdPushDescriptorSetKHR vkCmdDispatch vkCmdDispatchIndirect vkCmdPipelineBarrier2
vkCmdCopyBuffer vkCmdFillBuffer vkCmdCopyBufferToImage vkCmdCopyImageToBuffer vkCmdCopyImage
vkCmdClearColorImage vkCmdClearDepthStencilImage
vkCmdBeginRendering vkCmdEndRendering vkCmdSetViewport vkCmdSetScissor vkCmdBindVertexBuffers vkCmdBindIndexBuffer
vkCmdDraw vkCmdDrawIndexed vkCmdDrawIndirect vkCmdDrawIndexedIndirect vkCmdWriteTimestamp2""".split()

# Structs that only a pNext chain or a callback reaches.
CHAINED = """VkPhysicalDeviceVulkan11Features VkPhysicalDeviceVulkan12Features VkPhysicalDeviceVulkan13Features
VkPhysicalDeviceVulkan11Properties VkPhysicalDeviceVulkan12Properties VkPhysicalDeviceVulkan13Properties
VkPhysicalDeviceRobustness2FeaturesEXT VkPhysicalDeviceRobustness2PropertiesEXT VkPhysicalDevicePushDescriptorPropertiesKHR
VkSemaphoreTypeCreateInfo VkPipelineRenderingCreateInfo VkDebugUtilsMessengerCreateInfoEXT
VkDebugUtilsMessengerCallbackDataEXT""".split()

# Extensions whose enumerants are written beside those of Vulkan 1.0-1.3.
EXTENSIONS = {"VK_EXT_robustness2", "VK_KHR_push_descriptor", "VK_EXT_debug_utils"}

CONSTANTS = """VK_WHOLE_SIZE VK_REMAINING_MIP_LEVELS VK_REMAINING_ARRAY_LAYERS VK_QUEUE_FAMILY_IGNORED VK_LOD_CLAMP_NONE""".split()

PRIMITIVES = {
    "void": "void", "char": "byte", "float": "float", "double": "double", "int8_t": "sbyte", "uint8_t": "byte",
    "int16_t": "short", "uint16_t": "ushort", "int32_t": "int", "uint32_t": "uint", "int64_t": "long", "uint64_t": "ulong",
    "size_t": "nuint", "int": "int", "VkBool32": "VkBool32", "VkDeviceSize": "ulong", "VkDeviceAddress": "ulong",
    "VkSampleMask": "uint", "VkFlags": "uint", "VkFlags64": "ulong",
    "VkAllocationCallbacks": "void",    # always null here
}


class Registry:
    def __init__(self, path):
        root = ET.parse(path).getroot()
        self.types, self.commands, self.enums, self.constants = {}, {}, {}, {}
        for t in root.find("types"):
            name = t.get("name") or t.findtext("name")
            if name and for_vulkan(t):
                self.types[name] = t
        for c in root.find("commands"):
            if for_vulkan(c):
                self.commands[c.get("name") or c.findtext("proto/name")] = c
        for block in root.findall("enums"):
            if block.get("name") == "API Constants":
                self.constants = {e.get("name"): e.get("value") for e in block.findall("enum")}
            else:
                self.enums[block.get("name")] = {e.get("name"): value_of(e, 0) for e in block.findall("enum") if not e.get("alias")}
        for feature in root.findall("feature"):
            if for_vulkan(feature):
                self.extend(feature, 0)
        for extension in root.findall("extensions/extension"):
            if extension.get("name") in EXTENSIONS:
                self.extend(extension, int(extension.get("number")))
        header = next(t for t in root.find("types") if t.findtext("name") == "VK_HEADER_VERSION")
        self.version = re.search(r"VK_HEADER_VERSION\s+(\d+)", "".join(header.itertext())).group(1)

    def extend(self, node, number):
        for e in node.findall("require/enum"):
            if e.get("extends") and not e.get("alias"):
                self.enums.setdefault(e.get("extends"), {})[e.get("name")] = value_of(e, number)

    def resolve(self, name):
        while name in self.types and self.types[name].get("alias"):
            name = self.types[name].get("alias")
        return name


def for_vulkan(node):
    return "vulkan" in (node.get("api") or "vulkan").split(",")


def value_of(e, number):
    if e.get("bitpos") is not None:
        return 1 << int(e.get("bitpos"))
    if e.get("offset") is not None:
        value = 1000000000 + (int(e.get("extnumber") or number) - 1) * 1000 + int(e.get("offset"))
        return -value if e.get("dir") == "-" else value
    return int(e.get("value").rstrip("UL"), 0)


def shorten(enum, name):
    """VK_FORMAT_R8_UNORM of VkFormat becomes R8_UNORM; VK_ACCESS_2_NONE of VkAccessFlagBits2 becomes NONE."""
    words = re.findall(r"[A-Z][a-z]*|\d+|[A-Z]+(?![a-z])", re.sub(r"(KHR|EXT)$", "", enum).replace("FlagBits", ""))
    prefix = "_".join(w.upper() for w in words) + "_"
    short = name[len(prefix):] if name.startswith(prefix) else re.sub(r"^VK_", "", name)
    short = re.sub(r"_BIT(?=_|$)", "", short)
    short = re.sub(r"_(EXT|KHR)$", "", short) if enum.endswith(("EXT", "KHR")) else short
    return "_" + short if short[0].isdigit() else short


class Writer:
    def __init__(self, registry):
        self.registry, self.pending, self.seen, self.text = registry, [], set(), {}
        self.arrays = {}

    def reach(self, name):
        """C# name of a type; the type is queued to be written."""
        if name in PRIMITIVES:
            return PRIMITIVES[name]
        name = self.registry.resolve(name)
        node = self.registry.types[name]
        category = node.get("category")
        if category == "funcpointer":
            return "nint"
        if category == "bitmask":
            bits = node.get("requires") or node.get("bitvalues")
            if not bits or not self.registry.enums.get(bits):
                return "ulong" if node.findtext("type") == "VkFlags64" else "uint"
            name = bits
        if name not in self.seen:
            self.seen.add(name)
            self.pending.append(name)
        return cs_name(name)

    def declaration(self, node):
        """Type, name and array length of a member or parameter."""
        text = node.text or ""      # what stands between the tags: stars, brackets, and the names of array lengths
        for child in node:
            text += (child.text if child.tag == "enum" else "") + (child.tail or "") if child.tag != "comment" else ""
        if re.search(r":\s*\d+", text):
            raise SystemExit(f"{node.findtext('name')}: bit fields have no C# layout")
        stars = "*" * text.count("*")
        lengths = re.findall(r"\[\s*(\w+)\s*\]", text)
        if len(lengths) > 1:
            raise SystemExit(f"{node.findtext('name')}: arrays of arrays are not supported")
        length = None
        if lengths:
            length = int(lengths[0]) if lengths[0].isdigit() else int(self.registry.constants[lengths[0]], 0)
        return self.reach(node.findtext("type")) + stars, node.findtext("name"), length

    def write(self, name):
        category = self.registry.types[name].get("category")
        self.text[name] = {"enum": self.enum, "handle": self.handle, "struct": self.struct, "union": self.struct}[category](name)

    def enum(self, name):
        values = self.registry.enums.get(name, {})
        flags = "FlagBits" in name
        wide = any(v >= 1 << 32 for v in values.values())
        if name == "VkStructureType":
            values = {n: v for n, v in values.items() if n in self.structure_types}
        kind = ("ulong" if wide or name.endswith("FlagBits2") else "uint") if flags else "int"
        lines = {shorten(name, n): f"{v:#x}" if flags else str(v) for n, v in values.items()}
        body = "".join(f"        {n} = {v},\n" for n, v in lines.items())
        return f"{'    [Flags]' + chr(10) if flags else ''}    internal enum {cs_name(name)} : {kind}\n    {{\n{body}    }}\n"

    def handle(self, name):
        return f"    internal enum {name} : ulong {{ Null }}\n"

    def struct(self, name):
        node = self.registry.types[name]
        union = node.get("category") == "union"
        lines, structure_type = [], None
        for member in node.findall("member"):
            if not for_vulkan(member):
                continue
            kind, field, length = self.declaration(member)
            field = "@" + field if field in ("object", "event", "base", "params") else field
            at = "[FieldOffset(0)] " if union else ""
            if kind == "VkStructureType" and member.get("values"):
                structure_type = member.get("values")
                self.structure_types.add(structure_type)
            if length is None:
                lines.append(f"        {at}public {kind} {field};\n")
            elif kind in ("byte", "int", "uint", "ulong", "float"):
                lines.append(f"        {at}public fixed {kind} {field}[{length}];\n")
            else:
                array = f"{kind.replace('*', 'Pointer')}Array{length}"
                self.arrays[array] = f"    [InlineArray({length})] internal unsafe struct {array} {{ {kind} first; }}\n"
                lines.append(f"        {at}public {array} {field};\n")
        layout = "    [StructLayout(LayoutKind.Explicit)]\n" if union else ""
        if structure_type:
            lines.append(f"        public {name}() {{ sType = VkStructureType.{shorten('VkStructureType', structure_type)}; }}\n")
        return f"{layout}    internal unsafe struct {name}\n    {{\n{''.join(lines)}    }}\n"

    def command(self, name):
        node = self.registry.commands[name]
        parameters = []
        for parameter in node.findall("param"):
            if for_vulkan(parameter):
                kind, _, length = self.declaration(parameter)
                parameters.append(kind + ("*" if length else ""))
        return f"delegate* unmanaged<{', '.join(parameters + [self.reach(node.findtext('proto/type'))])}>"

    def table(self, title, remark, names):
        fields = "".join(f"        public readonly {self.command(n)} {n[2:]};\n" for n in names)
        loads = "".join(f"            {n[2:]} = ({self.command(n)})load({chr(34)}{n}{chr(34)}u8);\n" for n in names)
        return (f"    /// <summary>{remark}</summary>\n    internal sealed unsafe class {title}\n    {{\n{fields}\n"
                f"        public {title}(VulkanLoader load)\n        {{\n{loads}        }}\n    }}\n")

    structure_types = set()


def cs_name(name):
    return name.replace("FlagBits", "Flags")


def main():
    registry = Registry(sys.argv[1] if len(sys.argv) > 1 else "/usr/share/vulkan/registry/vk.xml")
    writer = Writer(registry)
    tables = [
        writer.table("VkGlobalCommands", "Commands that need no instance.", GLOBAL),
        writer.table("VkInstanceCommands", "Commands of one instance and its physical devices.", INSTANCE),
        writer.table("VkDeviceCommands", "Commands of one device, without the loader's indirection.", DEVICE),
    ]
    for name in CHAINED:
        writer.reach(name)
    while writer.pending:
        writer.write(writer.pending.pop())
    if "VkStructureType" in writer.seen:
        writer.write("VkStructureType")     # once more: only now are the structs in use known
    constants = "".join(constant(n, registry.constants[n]) for n in CONSTANTS)
    out = [
        f"// Written by generate.py beside this file from Khronos's registry vk.xml, version 1.3.{registry.version}. Change the lists there, not this.\n",
        "using System;\nusing System.Runtime.CompilerServices;\nusing System.Runtime.InteropServices;\n\n",
        "#pragma warning disable CS0169, CS0649\n\n",
        "namespace Host.Vulkan\n{\n",
        "    /// <summary>Address of a command by its zero-terminated name; throws when the driver has none.</summary>\n",
        "    internal unsafe delegate void* VulkanLoader(ReadOnlySpan<byte> name);\n\n",
        "    internal enum VkBool32 : uint { False, True }\n\n",
        f"    internal static class Vk\n    {{\n{constants}    }}\n\n",
        "\n".join(tables), "\n",
        "\n".join(writer.text[n] for n in sorted(writer.text)), "\n",
        "".join(writer.arrays[n] for n in sorted(writer.arrays)),
        "}\n",
    ]
    pathlib.Path(__file__).with_name("Vk.Generated.cs").write_text("".join(out))


def constant(name, value):
    number = value.strip("()")
    if number.endswith("F"):
        return f"        public const float {name} = {number[:-1]}f;\n"
    wide = "ULL" in number
    return f"        public const {'ulong' if wide else 'uint'} {name} = {number.replace('ULL', 'UL')};\n"


if __name__ == "__main__":
    main()
