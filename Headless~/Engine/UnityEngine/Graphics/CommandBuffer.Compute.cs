using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Collections;
using UnityEngine.Headless;

namespace UnityEngine.Rendering
{
    public partial class CommandBuffer
    {
        // Values set here stay on the ComputeShader for later dispatches, as in Unity.

        static T NotNull<T>(T value, string parameter, string call) where T : class =>
            value ?? throw new ArgumentNullException(parameter, $"CommandBuffer.{call}: {parameter} is null.");

        void Value<T>(ComputeShader shader, int id, PropertyKind kind, T value) where T : struct
        {
            NotNull(shader, "computeShader", "SetCompute*Param");
            ref Command c = ref Add(Op.ComputeValue);
            (c.Subject, c.A, c.Kind) = (shader, id, kind);
            Store(ref c, value);
        }

        void Value<T>(ComputeShader shader, int id, PropertyKind kind, T[] values) where T : struct
        {
            NotNull(shader, "computeShader", "SetCompute*Param");
            NotNull(values, "values", "SetCompute*Param");
            ref Command c = ref Add(Op.ComputeValue);
            (c.Subject, c.A, c.Kind) = (shader, id, kind);
            Store(ref c, values);
        }

        void Bind(ComputeShader shader, int kernel, int id, BufferStorage buffer)
        {
            NotNull(shader, "computeShader", "SetComputeBufferParam");
            if (buffer == null || buffer.IsReleased)
            {
                string call = $"SetComputeBufferParam of '{PropertyNames.ToName(id)}' on {shader.name}";
                BufferChecks.Alive(NotNull(buffer, "buffer", call), call);
            }
            if (!shader.CheckKernel(kernel, "SetComputeBufferParam"))
                return;
            ref Command c = ref Add(Op.ComputeBuffer);
            (c.Subject, c.A, c.B, c.Object) = (shader, id, kernel, buffer);
        }

        void BindConstants(ComputeShader shader, int id, BufferStorage buffer, int offset, int size)
        {
            NotNull(shader, "computeShader", "SetComputeConstantBufferParam");
            if (buffer == null)
                NotNull(buffer, "buffer", $"SetComputeConstantBufferParam of '{PropertyNames.ToName(id)}' on {shader.name}");
            ref Command c = ref Add(Op.ComputeConstantBuffer);
            (c.Subject, c.A, c.B, c.C, c.Object) = (shader, id, offset, size, buffer);
        }

        public void SetComputeFloatParam(ComputeShader computeShader, int nameID, float val) => Value(computeShader, nameID, PropertyKind.Float, val);
        public void SetComputeFloatParam(ComputeShader computeShader, string name, float val)
            => SetComputeFloatParam(computeShader, Shader.PropertyToID(name), val);
        public void SetComputeFloatParams(ComputeShader computeShader, int nameID, params float[] values)
            => Value(computeShader, nameID, PropertyKind.Float, values);
        public void SetComputeFloatParams(ComputeShader computeShader, string name, params float[] values)
            => SetComputeFloatParams(computeShader, Shader.PropertyToID(name), values);
        public void SetComputeIntParam(ComputeShader computeShader, int nameID, int val) => Value(computeShader, nameID, PropertyKind.Int, val);
        public void SetComputeIntParam(ComputeShader computeShader, string name, int val)
            => SetComputeIntParam(computeShader, Shader.PropertyToID(name), val);
        public void SetComputeIntParams(ComputeShader computeShader, int nameID, params int[] values)
            => Value(computeShader, nameID, PropertyKind.Int, values);
        public void SetComputeIntParams(ComputeShader computeShader, string name, params int[] values)
            => SetComputeIntParams(computeShader, Shader.PropertyToID(name), values);
        public void SetComputeVectorParam(ComputeShader computeShader, int nameID, Vector4 val)
            => Value(computeShader, nameID, PropertyKind.Vector, val);
        public void SetComputeVectorParam(ComputeShader computeShader, string name, Vector4 val)
            => SetComputeVectorParam(computeShader, Shader.PropertyToID(name), val);
        public void SetComputeVectorArrayParam(ComputeShader computeShader, int nameID, Vector4[] values)
            => Value(computeShader, nameID, PropertyKind.Vector, values);
        public void SetComputeVectorArrayParam(ComputeShader computeShader, string name, Vector4[] values)
            => SetComputeVectorArrayParam(computeShader, Shader.PropertyToID(name), values);
        public void SetComputeMatrixParam(ComputeShader computeShader, int nameID, Matrix4x4 val)
            => Value(computeShader, nameID, PropertyKind.Matrix, val);
        public void SetComputeMatrixParam(ComputeShader computeShader, string name, Matrix4x4 val)
            => SetComputeMatrixParam(computeShader, Shader.PropertyToID(name), val);
        public void SetComputeMatrixArrayParam(ComputeShader computeShader, int nameID, Matrix4x4[] values)
            => Value(computeShader, nameID, PropertyKind.Matrix, values);
        public void SetComputeMatrixArrayParam(ComputeShader computeShader, string name, Matrix4x4[] values)
            => SetComputeMatrixArrayParam(computeShader, Shader.PropertyToID(name), values);
        public void SetComputeConstantBufferParam(ComputeShader computeShader, int nameID, ComputeBuffer buffer, int offset, int size)
            => BindConstants(computeShader, nameID, buffer?.Storage, offset, size);
        public void SetComputeConstantBufferParam(ComputeShader computeShader, string name, ComputeBuffer buffer, int offset, int size)
            => SetComputeConstantBufferParam(computeShader, Shader.PropertyToID(name), buffer, offset, size);
        public void SetComputeConstantBufferParam(ComputeShader computeShader, int nameID, GraphicsBuffer buffer, int offset, int size)
            => BindConstants(computeShader, nameID, buffer?.Storage, offset, size);
        public void SetComputeConstantBufferParam(ComputeShader computeShader, string name, GraphicsBuffer buffer, int offset, int size)
            => SetComputeConstantBufferParam(computeShader, Shader.PropertyToID(name), buffer, offset, size);

        public void SetComputeBufferParam(ComputeShader computeShader, int kernelIndex, int nameID, ComputeBuffer buffer)
            => Bind(computeShader, kernelIndex, nameID, buffer?.Storage);
        public void SetComputeBufferParam(ComputeShader computeShader, int kernelIndex, string name, ComputeBuffer buffer)
            => SetComputeBufferParam(computeShader, kernelIndex, Shader.PropertyToID(name), buffer);
        public void SetComputeBufferParam(ComputeShader computeShader, int kernelIndex, int nameID, GraphicsBuffer buffer)
            => Bind(computeShader, kernelIndex, nameID, buffer?.Storage);
        public void SetComputeBufferParam(ComputeShader computeShader, int kernelIndex, string name, GraphicsBuffer buffer)
            => SetComputeBufferParam(computeShader, kernelIndex, Shader.PropertyToID(name), buffer);
        public void SetComputeBufferParam(ComputeShader computeShader, int kernelIndex, int nameID, GraphicsBufferHandle bufferHandle)
            => Bind(computeShader, kernelIndex, nameID, BufferStorage.OfHandle(bufferHandle));
        public void SetComputeBufferParam(ComputeShader computeShader, int kernelIndex, string name, GraphicsBufferHandle bufferHandle)
            => SetComputeBufferParam(computeShader, kernelIndex, Shader.PropertyToID(name), bufferHandle);
        public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, int nameID, RenderTargetIdentifier rt)
            => SetComputeTextureParam(computeShader, kernelIndex, nameID, rt, 0, RenderTextureSubElement.Default);
        public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, string name, RenderTargetIdentifier rt)
            => SetComputeTextureParam(computeShader, kernelIndex, Shader.PropertyToID(name), rt);
        public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, int nameID, RenderTargetIdentifier rt,
            int mipLevel) => SetComputeTextureParam(computeShader, kernelIndex, nameID, rt, mipLevel, RenderTextureSubElement.Default);
        public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, string name, RenderTargetIdentifier rt,
            int mipLevel) => SetComputeTextureParam(computeShader, kernelIndex, Shader.PropertyToID(name), rt, mipLevel);
        public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, string name, RenderTargetIdentifier rt,
            int mipLevel, RenderTextureSubElement element) => SetComputeTextureParam(computeShader, kernelIndex, Shader.PropertyToID(name),
            rt, mipLevel, element);

        public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, int nameID, RenderTargetIdentifier rt,
            int mipLevel, RenderTextureSubElement element)
        {
            NotNull(computeShader, "computeShader", "SetComputeTextureParam");
            if (!computeShader.CheckKernel(kernelIndex, "SetComputeTextureParam"))
                return;
            int target = AddTarget(rt);
            ref Command c = ref Add(Op.ComputeTexture);
            (c.Subject, c.A, c.B, c.C, c.D, c.E) = (computeShader, nameID, kernelIndex, target, mipLevel, (int)element);
        }

        public void SetComputeParamsFromMaterial(ComputeShader computeShader, int kernelIndex, Material material)
        {
            NotNull(computeShader, "computeShader", "SetComputeParamsFromMaterial");
            ref Command c = ref Add(Op.ComputeFromMaterial);
            (c.Subject, c.B, c.Object) = (computeShader, kernelIndex, NotNull(material, "material", "SetComputeParamsFromMaterial"));
        }

        public void EnableKeyword(ComputeShader computeShader, in LocalKeyword keyword) => SetKeyword(computeShader, keyword, true);
        public void DisableKeyword(ComputeShader computeShader, in LocalKeyword keyword) => SetKeyword(computeShader, keyword, false);

        public void SetKeyword(ComputeShader computeShader, in LocalKeyword keyword, bool value)
        {
            NotNull(computeShader, "computeShader", "SetKeyword");
            if (!KeywordUnion.Belongs(keyword, computeShader.Keywords))
                return;
            ref Command c = ref Add(Op.ComputeKeyword);
            (c.Subject, c.Object, c.Flag) = (computeShader, keyword.name, value);
        }

        // ---- dispatch

        public void DispatchCompute(ComputeShader computeShader, int kernelIndex, int threadGroupsX, int threadGroupsY, int threadGroupsZ)
        {
            NotNull(computeShader, "computeShader", "DispatchCompute");
            if (!computeShader.CheckKernel(kernelIndex, "DispatchCompute")
                || !GpuChecks.Groups(computeShader.KernelName(kernelIndex), threadGroupsX, threadGroupsY, threadGroupsZ))
                return;
            ref Command c = ref Add(Op.Dispatch);
            (c.Subject, c.B, c.C, c.D, c.E) = (computeShader, kernelIndex, threadGroupsX, threadGroupsY, threadGroupsZ);
        }

        public void DispatchCompute(ComputeShader computeShader, int kernelIndex, ComputeBuffer indirectBuffer, uint argsOffset)
            => Indirect(computeShader, kernelIndex, indirectBuffer?.Storage, argsOffset);
        public void DispatchCompute(ComputeShader computeShader, int kernelIndex, GraphicsBuffer indirectBuffer, uint argsOffset)
            => Indirect(computeShader, kernelIndex, indirectBuffer?.Storage, argsOffset);

        void Indirect(ComputeShader shader, int kernel, BufferStorage arguments, uint offset)
        {
            NotNull(shader, "computeShader", "DispatchCompute");
            if (!shader.CheckKernel(kernel, "DispatchCompute"))
                return;
            BufferChecks.Alive(NotNull(arguments, "indirectBuffer", shader.KernelName(kernel)), shader.KernelName(kernel));
            ref Command c = ref Add(Op.DispatchIndirect);
            (c.Subject, c.B, c.C, c.Object) = (shader, kernel, (int)offset, arguments);
        }

        // ---- buffers

        void BufferData(BufferStorage buffer, int elementBytes, int bufferStart, ReadOnlySpan<byte> bytes)
        {
            if (bytes.IsEmpty)
                return;
            ref Command c = ref Add(Op.BufferData);
            (c.Object, c.A) = (buffer, checked((int)((long)bufferStart * elementBytes)));
            Store(ref c, bytes);
        }

        void BufferData(BufferStorage buffer, Array data, int managedStart, int bufferStart, int count)
        {
            using NativeWork.Scope native = NativeWork.Enter();
            CopyArray(buffer, data, managedStart, bufferStart, count);
        }

        // Apart, because what a lambda captures is allocated where its method begins: here, in native code's name.
        void CopyArray(BufferStorage buffer, Array data, int managedStart, int bufferStart, int count)
        {
            NotNull(buffer, "buffer", "SetBufferData");
            int size = BufferBytes.ElementSize(NotNull(data, "data", "SetBufferData"), "CommandBuffer.SetBufferData");
            BufferChecks.Range(buffer, "SetBufferData", data.Length, size, managedStart, bufferStart, count);
            if (count > 0)
                BufferBytes.With(data, (long)managedStart * size, (long)count * size, bytes => BufferData(buffer, size, bufferStart, bytes));
        }

        void BufferData<T>(BufferStorage buffer, NativeArray<T> data, int nativeStart, int bufferStart, int count) where T : struct
        {
            NotNull(buffer, "buffer", "SetBufferData");
            int size = ElementSize<T>.Bytes;
            BufferChecks.Range(buffer, "SetBufferData", data.Length, size, nativeStart, bufferStart, count);
            BufferData(buffer, size, bufferStart, Transfer.Bytes(data).Slice(nativeStart * size, count * size));
            if (Player.Strict && count > 0)
                Watch(data.GetSubArray(nativeStart, count));
        }

        // Whether Unity copies a NativeArray as it is recorded or as it is executed, no documentation says.
        void Watch<T>(NativeArray<T> data) where T : struct
        {
            using NativeWork.Scope native = NativeWork.Enter();
            commands[commandCount - 1].Subject = new RecordedArray<T>(data);
        }

        public void SetBufferData(ComputeBuffer buffer, Array data) => BufferData(buffer?.Storage, data, 0, 0, data?.Length ?? 0);
        public void SetBufferData(ComputeBuffer buffer, Array data, int managedBufferStartIndex, int graphicsBufferStartIndex, int count)
            => BufferData(buffer?.Storage, data, managedBufferStartIndex, graphicsBufferStartIndex, count);
        public void SetBufferData<T>(ComputeBuffer buffer, List<T> data) where T : struct
            => BufferData(buffer?.Storage, data?.ToArray(), 0, 0, data?.Count ?? 0);
        public void SetBufferData<T>(ComputeBuffer buffer, List<T> data, int managedBufferStartIndex, int graphicsBufferStartIndex,
            int count) where T : struct => BufferData(buffer?.Storage, data?.ToArray(), managedBufferStartIndex, graphicsBufferStartIndex,
            count);
        public void SetBufferData<T>(ComputeBuffer buffer, NativeArray<T> data) where T : struct
            => BufferData(buffer?.Storage, data, 0, 0, data.Length);
        public void SetBufferData<T>(ComputeBuffer buffer, NativeArray<T> data, int nativeBufferStartIndex, int graphicsBufferStartIndex,
            int count) where T : struct => BufferData(buffer?.Storage, data, nativeBufferStartIndex, graphicsBufferStartIndex, count);
        public void SetBufferCounterValue(ComputeBuffer buffer, uint counterValue) => CounterValue(buffer?.Storage, counterValue);
        public void SetBufferData(GraphicsBuffer buffer, Array data) => BufferData(buffer?.Storage, data, 0, 0, data?.Length ?? 0);
        public void SetBufferData(GraphicsBuffer buffer, Array data, int managedBufferStartIndex, int graphicsBufferStartIndex, int count)
            => BufferData(buffer?.Storage, data, managedBufferStartIndex, graphicsBufferStartIndex, count);
        public void SetBufferData<T>(GraphicsBuffer buffer, List<T> data) where T : struct
            => BufferData(buffer?.Storage, data?.ToArray(), 0, 0, data?.Count ?? 0);
        public void SetBufferData<T>(GraphicsBuffer buffer, List<T> data, int managedBufferStartIndex, int graphicsBufferStartIndex,
            int count) where T : struct => BufferData(buffer?.Storage, data?.ToArray(), managedBufferStartIndex, graphicsBufferStartIndex,
            count);
        public void SetBufferData<T>(GraphicsBuffer buffer, NativeArray<T> data) where T : struct
            => BufferData(buffer?.Storage, data, 0, 0, data.Length);
        public void SetBufferData<T>(GraphicsBuffer buffer, NativeArray<T> data, int nativeBufferStartIndex, int graphicsBufferStartIndex,
            int count) where T : struct => BufferData(buffer?.Storage, data, nativeBufferStartIndex, graphicsBufferStartIndex, count);
        public void SetBufferCounterValue(GraphicsBuffer buffer, uint counterValue) => CounterValue(buffer?.Storage, counterValue);
        public void CopyCounterValue(ComputeBuffer src, ComputeBuffer dst, uint dstOffsetBytes)
            => CopyCounter(src?.Storage, dst?.Storage, dstOffsetBytes);
        public void CopyCounterValue(ComputeBuffer src, GraphicsBuffer dst, uint dstOffsetBytes)
            => CopyCounter(src?.Storage, dst?.Storage, dstOffsetBytes);
        public void CopyCounterValue(GraphicsBuffer src, ComputeBuffer dst, uint dstOffsetBytes)
            => CopyCounter(src?.Storage, dst?.Storage, dstOffsetBytes);
        public void CopyCounterValue(GraphicsBuffer src, GraphicsBuffer dst, uint dstOffsetBytes)
            => CopyCounter(src?.Storage, dst?.Storage, dstOffsetBytes);

        void CounterValue(BufferStorage buffer, uint value)
        {
            NotNull(buffer, "buffer", "SetBufferCounterValue");
            if (!BufferChecks.Counter(buffer, "SetBufferCounterValue"))
                return;
            ref Command c = ref Add(Op.BufferCounter);
            (c.Object, c.A) = (buffer, (int)value);
        }

        void CopyCounter(BufferStorage source, BufferStorage target, uint offset)
        {
            NotNull(source, "src", "CopyCounterValue");
            NotNull(target, "dst", "CopyCounterValue");
            if (!BufferChecks.CopyCount(source, target, offset))
                return;
            ref Command c = ref Add(Op.CopyCounter);
            (c.Subject, c.Object, c.A) = (source, target, (int)offset);
        }

        public void CopyBuffer(GraphicsBuffer source, GraphicsBuffer dest)
        {
            ref Command c = ref Add(Op.CopyBuffer);
            (c.Subject, c.Object) = (NotNull(source, "source", "CopyBuffer").Storage, NotNull(dest, "dest", "CopyBuffer").Storage);
        }

        // ---- read-backs: requested when the command executes

        public void WaitAllAsyncReadbackRequests() => Add(Op.WaitReadbacks);

        void Readback(RecordedReadback readback) => Add(Op.Readback).Subject = readback;

        public void RequestAsyncReadback(ComputeBuffer src, Action<AsyncGPUReadbackRequest> callback)
            => Readback(new RecordedReadback(src?.Storage, 0, -1, callback));
        public void RequestAsyncReadback(ComputeBuffer src, int size, int offset, Action<AsyncGPUReadbackRequest> callback)
            => Readback(new RecordedReadback(src?.Storage, offset, size, callback));
        public void RequestAsyncReadbackIntoNativeArray<T>(ref NativeArray<T> output, ComputeBuffer src,
            Action<AsyncGPUReadbackRequest> callback) where T
            : struct => Readback(new RecordedReadback(src?.Storage, 0, -1, callback) { Output = ReadbackOutput.Of(output) });
        public void RequestAsyncReadbackIntoNativeArray<T>(ref NativeArray<T> output, ComputeBuffer src, int size, int offset,
            Action<AsyncGPUReadbackRequest> callback) where T
            : struct => Readback(new RecordedReadback(src?.Storage, offset, size, callback) { Output = ReadbackOutput.Of(output) });
        public void RequestAsyncReadback(GraphicsBuffer src, Action<AsyncGPUReadbackRequest> callback)
            => Readback(new RecordedReadback(src?.Storage, 0, -1, callback));
        public void RequestAsyncReadback(GraphicsBuffer src, int size, int offset, Action<AsyncGPUReadbackRequest> callback)
            => Readback(new RecordedReadback(src?.Storage, offset, size, callback));
        public void RequestAsyncReadbackIntoNativeArray<T>(ref NativeArray<T> output, GraphicsBuffer src,
            Action<AsyncGPUReadbackRequest> callback) where T
            : struct => Readback(new RecordedReadback(src?.Storage, 0, -1, callback) { Output = ReadbackOutput.Of(output) });
        public void RequestAsyncReadbackIntoNativeArray<T>(ref NativeArray<T> output, GraphicsBuffer src, int size, int offset,
            Action<AsyncGPUReadbackRequest> callback) where T
            : struct => Readback(new RecordedReadback(src?.Storage, offset, size, callback) { Output = ReadbackOutput.Of(output) });
        public void RequestAsyncReadback(Texture src, Action<AsyncGPUReadbackRequest> callback) => Readback(new RecordedReadback(src, 0, callback));
        public void RequestAsyncReadback(Texture src, int mipIndex, Action<AsyncGPUReadbackRequest> callback)
            => Readback(new RecordedReadback(src, mipIndex, callback));
        public void RequestAsyncReadbackIntoNativeArray<T>(ref NativeArray<T> output, Texture src,
            Action<AsyncGPUReadbackRequest> callback) where T
            : struct => Readback(new RecordedReadback(src, 0, callback) { Output = ReadbackOutput.Of(output) });
        public void RequestAsyncReadbackIntoNativeArray<T>(ref NativeArray<T> output, Texture src, int mipIndex,
            Action<AsyncGPUReadbackRequest> callback) where T
            : struct => Readback(new RecordedReadback(src, mipIndex, callback) { Output = ReadbackOutput.Of(output) });
    }
}
