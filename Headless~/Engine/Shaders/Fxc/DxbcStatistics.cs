namespace Host.Shaders
{
    /// <summary>The counts that D3D11_SHADER_DESC takes from the STAT chunk, as far as a budget needs them.</summary>
    readonly struct DxbcStatistics
    {
        /// <summary>D3D11_SHADER_DESC.InstructionCount, FXC's "instruction slots used".</summary>
        public readonly int Instructions;
        /// <summary>D3D11_SHADER_DESC.TempRegisterCount, registers of four words.</summary>
        public readonly int TempRegisters;

        public DxbcStatistics(DxbcContainer container)
        {
            byte[] counts = container.Chunk("STAT");
            Instructions = (int)DxbcContainer.UInt(counts, 0);
            TempRegisters = (int)DxbcContainer.UInt(counts, 4);
        }
    }
}
