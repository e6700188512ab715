using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Headless;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    /// <summary>
    /// Commands of a renderer beside a camera: depth-only targets and their slices, targets that add up, kernels on textures, and what
    /// it hooks into one camera's frame. Pictures of 64 x 32.
    /// </summary>
    public class CameraCommandTests : ShaderTextFixture
    {
        const int Width = 64, Height = 32;
        static readonly Bounds everywhere = new Bounds(Vector3.zero, Vector3.one * 1000);

        [TearDown]
        public void Unhook()
        {
            Camera.onPreCull = null;
            Player.Stereo = false;
        }

        static Material MaterialOf(string code, string state = "", string queue = "Geometry") => new Material(ShaderOf($@"Shader ""Test/Commands"" {{
SubShader {{ Tags {{ ""Queue"" = ""{queue}"" }} Cull Off {state} Pass {{
HLSLPROGRAM
#pragma target 5.0
#pragma vertex vert
#pragma fragment frag
{code}
ENDHLSL
}} }} }}"));

        // A triangle over the whole picture at a depth of the device.
        const string Everywhere = "float _Depth; float4 vert(uint id : SV_VertexID) : SV_Position { return float4(id == 1 ? 3 : -1, id " +
            "== 2 ? 3 : -1, _Depth, 1); }\n";

        static RenderTexture Target(GraphicsFormat color, GraphicsFormat depth = GraphicsFormat.None, int slices = 1, bool write = false)
        {
            var target = new RenderTexture(new RenderTextureDescriptor(Width, Height, color, depth) { dimension = slices > 1
                ? TextureDimension.Tex2DArray : TextureDimension.Tex2D, volumeDepth = slices, enableRandomWrite = write });
            target.Create();
            return target;
        }

        static MaterialPropertyBlock Depth(float depth)
        {
            var block = new MaterialPropertyBlock();
            block.SetFloat("_Depth", depth);
            return block;
        }

        static float[] Floats(RenderTexture texture, int slice = 0)
        {
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(texture, 0, 0, texture.width, 0, texture.height, slice, 1);
            request.WaitForCompletion();
            return request.GetData<float>().ToArray();
        }

        [Test]
        public void Draws_go_into_one_slice_of_a_depth_only_target_and_kernels_and_pixels_read_it([Values(1, 2)] int slices, [Values] bool indirect)
        {
            RenderTexture depth = Target(GraphicsFormat.None, GraphicsFormat.D32_SFloat, slices), seen = Target(GraphicsFormat.R32_SFloat),
                computed = Target(GraphicsFormat.R32_SFloat, write: true);
            string array = slices > 1 ? "Texture2DArray<float> _Read;" : "Texture2D<float> _Read;", at = slices > 1
                ? $"int4(at, {slices - 1}, 0)" : "int3(at, 0)";
            Material draw = MaterialOf(Everywhere + "void frag() { }", "ColorMask 0");
            Material read = MaterialOf(Everywhere + array
                + $"float4 frag(float4 p : SV_Position) : SV_Target {{ int2 at = p.xy; return _Read.Load({at}) * 2; }}",
                "ZTest Always ZWrite Off");
            ComputeShader kernel = ComputeOf($"#pragma kernel Read\n{array} RWTexture2D<float> _Out;\n[numthreads(8, 8, 1)] void " +
                $"Read(uint2 at : SV_DispatchThreadID) {{ _Out[at] = _Read.Load({at}) * 4; }}");
            using var arguments = new GraphicsBuffer(GraphicsBuffer.Target.IndirectArguments, 4, 4);
            arguments.SetData(new uint[] { 3, 1, 0, 0 });
            var block = new MaterialPropertyBlock();
            block.SetTexture("_Read", depth, RenderTextureSubElement.Depth);

            using var cmd = new CommandBuffer();
            for (int slice = 0; slice < slices; slice++)
            {
                cmd.SetRenderTarget(depth, 0, CubemapFace.Unknown, slice);
                cmd.ClearRenderTarget(true, false, Color.clear);
                if (indirect)
                    cmd.DrawProceduralIndirect(Matrix4x4.identity, draw, 0, MeshTopology.Triangles, arguments, 0, Depth(0.125f * (slice + 1)));
                else
                    cmd.DrawProcedural(Matrix4x4.identity, draw, 0, MeshTopology.Triangles, 3, 1, Depth(0.125f * (slice + 1)));
            }
            cmd.SetRenderTarget(seen);
            cmd.DrawProcedural(Matrix4x4.identity, read, 0, MeshTopology.Triangles, 3, 1, block);
            cmd.SetComputeTextureParam(kernel, 0, "_Read", depth, 0, RenderTextureSubElement.Depth);
            cmd.SetComputeTextureParam(kernel, 0, "_Out", computed);
            cmd.DispatchCompute(kernel, 0, Width / 8, Height / 8, 1);
            Graphics.ExecuteCommandBuffer(cmd);

            float expected = 0.125f * slices;
            Assert.That(Floats(seen), Is.All.EqualTo(expected * 2), "a pixel program by a property block");
            Assert.That(Floats(computed), Is.All.EqualTo(expected * 4), "a kernel");
            foreach (RenderTexture texture in new[] { depth, seen, computed })
                Object.DestroyImmediate(texture);
        }

        [Test]
        public void The_nearest_of_depths_that_pixels_write_wins_also_where_they_promise_a_direction(
            [Values("SV_Depth", "SV_DepthLessEqual", "SV_DepthGreaterEqual")] string semantic)
        {
            RenderTexture depth = Target(GraphicsFormat.None, GraphicsFormat.D32_SFloat);
            float drawn = semantic == "SV_DepthLessEqual" ? 1 : 0;      // on the side from which it promises to come
            Material draw = MaterialOf(Everywhere
            + $"float _Own; void frag(float4 p : SV_Position, out float depth : {semantic}) {{ depth = p.x < 32 ? _Own : 0.25; }}",
            "ColorMask 0 ZTest LEqual");
            using var cmd = new CommandBuffer();
            cmd.SetRenderTarget(depth);
            cmd.ClearRenderTarget(true, false, Color.clear);
            foreach (float own in new[] { 0.5f, 0.75f, 0.125f })
            {
                MaterialPropertyBlock block = Depth(drawn);
                block.SetFloat("_Own", own);
                cmd.DrawProcedural(Matrix4x4.identity, draw, 0, MeshTopology.Triangles, 3, 1, block);
            }
            Graphics.ExecuteCommandBuffer(cmd);
            float[] result = Floats(depth);
            Assert.That((result[10], result[50]), Is.EqualTo((0.75f, 0.25f)), "depth is reversed: the nearest is the greatest");
            Object.DestroyImmediate(depth);
        }

        [Test]
        public void A_half_float_target_adds_up([Values(1, 2)] int slices)
        {
            RenderTexture sum = Target(GraphicsFormat.R16_SFloat, GraphicsFormat.None, slices);
            Material add = MaterialOf(Everywhere + "float _Amount; float frag() : SV_Target { return _Amount; }",
                "Blend One One ZTest Always ZWrite Off");
            using var cmd = new CommandBuffer();
            cmd.SetRenderTarget(sum, 0, CubemapFace.Unknown, slices - 1);
            cmd.ClearRenderTarget(false, true, Color.clear);
            var block = new MaterialPropertyBlock();
            foreach (float amount in new[] { 0.5f, 1.25f, 100f })
            {
                block.SetFloat("_Amount", amount);
                cmd.DrawProcedural(Matrix4x4.identity, add, 0, MeshTopology.Triangles, 3, 2, block);
            }
            Graphics.ExecuteCommandBuffer(cmd);
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(sum, 0, 0, Width, 0, Height, slices - 1, 1);
            request.WaitForCompletion();
            Assert.That(request.GetData<ushort>().Select(h => Mathf.HalfToFloat(h)), Is.All.EqualTo(203.5f));
            Object.DestroyImmediate(sum);
        }

        [Test]
        public void Kernels_write_textures_and_read_what_they_wrote([Values(GraphicsFormat.R32_SFloat, GraphicsFormat.R16_SFloat,
            GraphicsFormat.R16G16B16A16_SFloat)] GraphicsFormat format, [Values(1, 2)] int slices)
        {
            RenderTexture first = Target(format, GraphicsFormat.None, slices, true), second = Target(format, GraphicsFormat.None, slices, true);
            string type = format == GraphicsFormat.R16G16B16A16_SFloat ? "float4" : "float", suffix = slices > 1 ? "Array" : "";
            string parameter = slices > 1 ? "uint3 at" : "uint2 at", load = slices > 1 ? "int4(at, 0)" : "int3(at, 0)", slice = slices > 1 ? "at.z"
                : "0";
            ComputeShader kernels = ComputeOf(
                $"#pragma kernel Write\n#pragma kernel Double\nRWTexture2D{suffix}<{type}> _Out; Texture2D{suffix}<{type}> _In;\n" +
                $"[numthreads(8, 8, 1)] void Write({parameter} : SV_DispatchThreadID) {{ _Out[at] = at.x + 100 * {slice}; " +
                $"}}\n[numthreads(8, 8, 1)] void Double({parameter} : SV_DispatchThreadID) {{ _Out[at] = 2 * _In.Load({load}); }}");
            using var cmd = new CommandBuffer();
            cmd.SetComputeTextureParam(kernels, 0, "_Out", first);
            cmd.DispatchCompute(kernels, 0, Width / 8, Height / 8, slices);
            cmd.SetComputeTextureParam(kernels, 1, "_In", first);
            cmd.SetComputeTextureParam(kernels, 1, "_Out", second);
            cmd.DispatchCompute(kernels, 1, Width / 8, Height / 8, slices);
            Graphics.ExecuteCommandBuffer(cmd);
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(second, 0, 0, Width, 0, Height, slices - 1, 1);
            request.WaitForCompletion();
            float[] values = format == GraphicsFormat.R32_SFloat ? request.GetData<float>().ToArray()
                : request.GetData<ushort>().Select(h => Mathf.HalfToFloat(h)).ToArray();
            int components = type == "float4" ? 4 : 1;
            Assert.That(Enumerable.Range(0, Width).Select(x => values[x * components]),
                Is.EqualTo(Enumerable.Range(0, Width).Select(x => 2f * (x + 100 * (slices - 1)))));
            Object.DestroyImmediate(first);
            Object.DestroyImmediate(second);
        }

        [Test]
        public void What_filters_32_bit_floats_is_refused_by_name(
            [Values(GraphicsFormat.R32_SFloat, GraphicsFormat.R32G32B32A32_SFloat, GraphicsFormat.R16_SFloat)] GraphicsFormat format,
            [Values("inline linear", "inline point", "own linear", "own point", "handed on")] string sampler, [Values] bool drawn)
        {
            RenderTexture source = Target(format), target = Target(GraphicsFormat.R16G16B16A16_SFloat, write: true);
            source.filterMode = sampler == "own linear" ? FilterMode.Bilinear : FilterMode.Point;
            string name = sampler.StartsWith("own") ? "sampler_Seen" : sampler == "inline point" ? "my_point_clamp_sampler"
                : "my_linear_clamp_sampler";
            string code = $"Texture2D _Seen; Texture2D _Other; SamplerState {name};\n" + "float4 Read(Texture2D t, SamplerState s) " +
                "{ return t.SampleLevel(s, float2(0.3, 0.3), 0); }\n", read = sampler == "handed on" ? $"Read(_Seen, {name})"
                : $"_Seen.SampleLevel({name}, float2(0.3, 0.3), 0)";
            void Run()
            {
                using var cmd = new CommandBuffer();
                if (drawn)
                {
                    var block = Depth(0.5f);
                    block.SetTexture("_Seen", source);
                    cmd.SetRenderTarget(target);
                    cmd.DrawProcedural(Matrix4x4.identity, MaterialOf(Everywhere + code + $"float4 frag() : SV_Target {{ return {read} " +
                        "+ _Other.Load(int3(0, 0, 0)); }"), 0, MeshTopology.Triangles, 3, 1, block);
                }
                else
                {
                    ComputeShader kernels = ComputeOf($"#pragma kernel Read1\n{code}RWTexture2D<float4> _Out;\n" +
                        $"[numthreads(8, 8, 1)] void Read1(uint2 at : SV_DispatchThreadID) {{ _Out[at] = {read}; }}");
                    cmd.SetComputeTextureParam(kernels, 0, "_Seen", source);
                    cmd.SetComputeTextureParam(kernels, 0, "_Out", target);
                    cmd.DispatchCompute(kernels, 0, 1, 1, 1);
                }
                Graphics.ExecuteCommandBuffer(cmd);
            }
            if (format == GraphicsFormat.R16_SFloat || sampler.EndsWith("point"))
                Run();
            else
                Assert.That(Assert.Throws<GpuUsageException>(Run).Message,
                    Does.Contain("'_Seen' (RenderTexture 64 x 32)").And.Contain(name).And.Contain("32-bit floats"));
            Object.DestroyImmediate(source);
            Object.DestroyImmediate(target);
        }

        // Shows a texture of its own block over the whole picture, in the transparent queue.
        static Material Show() => MaterialOf(Everywhere + "Texture2D _Seen; float4 _Tint; float4 frag(float4 p : SV_Position) : " +
            "SV_Target { return _Seen.Load(int3(p.xy, 0)).grba * _Tint; }", "ZTest Always ZWrite Off", "Transparent");

        [Test]
        public void A_draw_for_one_camera_has_a_block_of_its_own_and_is_in_no_other_camera()
        {
            Material material = MaterialOf(Everywhere + "float4 _Tint; float4 frag() : SV_Target { return _Tint; }", "ZTest Always");
            Camera[] cameras = { NewCamera(), NewCamera(), NewCamera() };
            for (int i = 0; i < 3; i++)
                cameras[i].targetTexture = new RenderTexture(Width, Height, 24, RenderTextureFormat.ARGB32, RenderTextureReadWrite.Linear);
            Color[] tints = { Color.red, Color.green };
            for (int i = 0; i < 2; i++)
            {
                var block = new MaterialPropertyBlock();
                block.SetVector("_Tint", tints[i]);
                Graphics.RenderPrimitives(new RenderParams(material) { worldBounds = everywhere, camera = cameras[i], matProps = block },
                    MeshTopology.Triangles, 3);
            }
            Frame();
            Assert.That(cameras.Select(c => Pixel(5, 5, c.targetTexture)),
                Is.EqualTo(new[] { new Color32(255, 0, 0, 255), new Color32(0, 255, 0, 255), new Color32(0, 0, 255, 255) }));
            foreach (Camera camera in cameras)
                Object.DestroyImmediate(camera.targetTexture);
        }

        [TestCase("screen", "blit")]
        [TestCase("texture", "blit")]
        [TestCase("texture", "copy")]
        [TestCase("hdr texture", "blit")]
        [TestCase("hdr texture", "copy")]
        public void The_opaque_picture_is_copied_before_the_transparent_queue_reads_it(string target, string by)
        {
            bool toTexture = target != "screen", blit = by == "blit", hdr = target.StartsWith("hdr");
            Camera camera = NewCamera();
            if (toTexture)
                camera.targetTexture = new RenderTexture(Width, Height, 24, hdr ? RenderTextureFormat.ARGBHalf : RenderTextureFormat.ARGB32);
            GraphicsFormat format = toTexture && !blit ? camera.targetTexture.graphicsFormat : GraphicsFormat.R16G16B16A16_SFloat;
            RenderTexture own = Target(format);
            Material opaque = MaterialOf(Everywhere + "float4 frag() : SV_Target { return float4(1, 0.25, 0, 1); }",
                "ZTest Always ZWrite Off"), show = Show();

            using var cmd = new CommandBuffer();
            if (blit)
                cmd.Blit(BuiltinRenderTextureType.CameraTarget, own);
            else
                cmd.CopyTexture(BuiltinRenderTextureType.CameraTarget, own);
            camera.AddCommandBuffer(CameraEvent.BeforeForwardAlpha, cmd);
            var block = new MaterialPropertyBlock();
            block.SetTexture("_Seen", own);
            block.SetVector("_Tint", Vector4.one);
            Graphics.RenderPrimitives(new RenderParams(opaque) { worldBounds = everywhere }, MeshTopology.Triangles, 3);
            Graphics.RenderPrimitives(new RenderParams(show) { worldBounds = everywhere, matProps = block }, MeshTopology.Triangles, 3);
            Frame();
            Color32 pixel = Pixel(40, 20, camera.targetTexture);     // in bytes of what is stored: linear numbers where it is float
            Assert.That(pixel.r, Is.EqualTo(hdr ? 64 : 137).Within(1), "red and green have changed places");
            Assert.That(pixel.g, Is.EqualTo(255));
            Object.DestroyImmediate(own);
            if (toTexture)
            {
                Object.DestroyImmediate(camera.targetTexture);
                camera.targetTexture = null;
            }
        }

        // Like Direct3D: a texture's picture is flipped, and that of the back buffer is not.
        [Test]
        public void A_copy_of_the_back_buffer_is_upside_down_and_its_picture_is_not(
            [Values("", "allowHDR", "forced", "antialiased", "effect")] string path, [Values] bool part)
        {
            var camera = new GameObject("Camera").AddComponent<Camera>();
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = Color.black;
            camera.rect = new Rect(0, part ? 0.5f : 0, 1, part ? 0.5f : 1);
            camera.allowHDR = path == "allowHDR";
            camera.forceIntoRenderTexture = path == "forced";
            if (path == "effect")
                camera.gameObject.AddComponent<PassingEffect>();
            GameObject above = GameObject.CreatePrimitive(PrimitiveType.Quad);      // one sided: its winding counts
            above.transform.position = new Vector3(0, 5, 5);
            above.transform.localScale = new Vector3(100, 10, 1);
            above.GetComponent<MeshRenderer>().sharedMaterial = new Material(Shader.Find("Unlit/Color")) { color = Color.white };
            var copy = new RenderTexture(Player.ScreenWidth, Player.ScreenHeight, 0);
            var commands = new CommandBuffer();
            commands.Blit(BuiltinRenderTextureType.CameraTarget, copy);
            camera.AddCommandBuffer(CameraEvent.BeforeForwardAlpha, commands);
            QualitySettings.antiAliasing = path == "antialiased" ? 4 : 0;
            try
            {
                PlayerLoop.Frame(0.02f);
            }
            finally
            {
                QualitySettings.antiAliasing = 0;
            }
            int height = Player.ScreenHeight, low = part ? height / 2 : 0;
            bool isForcedPart = part && path == "forced";        // into a texture of the part's size
            (int, int) seen = isForcedPart ? (height / 2, height) : ((height + low) / 2, height);
            (int, int) copied = BrightRows(copy);
            copy.Release();
            commands.Dispose();
            Assert.That(BrightRows(ScreenTarget.Texture), Is.EqualTo(((height + low) / 2, height)), "as it is seen");
            Assert.That(copied, Is.EqualTo(path == "" ? (0, height - (height + low) / 2) : seen), "copied");
        }

        sealed class PassingEffect : MonoBehaviour
        {
            void OnRenderImage(RenderTexture source, RenderTexture destination) => Graphics.Blit(source, destination);
        }

        // The first that is bright and the first after, from the bottom.
        static (int, int) BrightRows(RenderTexture texture)
        {
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(texture);
            request.WaitForCompletion();
            Color32[] pixels = request.GetData<Color32>().ToArray();
            int[] rows = Enumerable.Range(0, texture.height).Where(y => pixels[y * texture.width + texture.width / 2].r > 200).ToArray();
            return rows.Length == 0 ? (0, 0) : (rows[0], rows[^1] + 1);
        }

        [Test]
        public void CopyTexture_from_the_screen_is_refused_by_name()
        {
            Camera camera = NewCamera();
            RenderTexture own = Target(GraphicsFormat.R8G8B8A8_SRGB);
            using var cmd = new CommandBuffer();
            cmd.CopyTexture(BuiltinRenderTextureType.CameraTarget, own);
            camera.AddCommandBuffer(CameraEvent.BeforeForwardAlpha, cmd);
            Assert.That(() => camera.Render(), Throws.TypeOf<GpuUsageException>().With.Message.Contains("use Blit"));
            Object.DestroyImmediate(own);
        }

        [Test]
        public void What_onPreCull_adds_is_drawn_in_the_same_frame_of_that_camera([Values] bool stereo)
        {
            Player.Stereo = stereo;
            Camera watched = NewCamera(), other = NewCamera();
            other.targetTexture = new RenderTexture(Width, Height, 24);
            RenderTexture own = Target(GraphicsFormat.R8G8B8A8_UNorm);
            Material draw = MaterialOf(Everywhere + "float4 frag() : SV_Target { return float4(1, 0, 0, 1); }", "ZTest Always");
            int executed = 0;
            using var cmd = new CommandBuffer();
            cmd.SetRenderTarget(own);
            cmd.ClearRenderTarget(false, true, Color.green);
            Camera.onPreCull += camera =>
            {
                if (camera != watched)
                    return;
                executed++;
                camera.AddCommandBuffer(CameraEvent.BeforeForwardAlpha, cmd);
                Graphics.RenderPrimitives(new RenderParams(draw) { worldBounds = everywhere, camera = camera }, MeshTopology.Triangles, 3);
            };
            Frame();
            Assert.That(executed, Is.EqualTo(1));
            Assert.That(Read(own)[0].y, Is.EqualTo(1), "the command buffer ran");
            Assert.That(Pixel(5, 5), Is.EqualTo(new Color32(255, 0, 0, 255)), "the draw is there");
            Assert.That(Pixel(5, 5, other.targetTexture), Is.EqualTo(new Color32(0, 0, 255, 255)), "and nowhere else");
            Object.DestroyImmediate(own);
            Object.DestroyImmediate(other.targetTexture);
        }

        [Test]
        public void With_two_eyes_the_target_is_an_array_whose_slices_are_copied_one_by_one()
        {
            Player.Stereo = true;
            Camera camera = NewCamera();
            RenderTexture own = new RenderTexture(new RenderTextureDescriptor(Width / 2, Height, GraphicsFormat.R16G16B16A16_SFloat,
                GraphicsFormat.None) { dimension = TextureDimension.Tex2DArray, volumeDepth = 2 });
            const string eye = "struct v2f { float4 p : SV_Position; uint eye : SV_RenderTargetArrayIndex; };\nv2f vert(uint id : " +
                "SV_VertexID, uint instance : SV_InstanceID) { v2f o; o.p = float4(id == 1 ? 3 : -1, id == 2 ? 3 : -1, 0, 1);\n#ifdef " +
                "STEREO_INSTANCING_ON\no.eye = instance & 1;\n#else\no.eye = 0;\n#endif\nreturn o; }\n";
            Material opaque =
                MaterialOf(eye + "float4 frag(v2f i) : SV_Target { return i.eye == 0 ? float4(1, 0, 0, 1) : float4(0, 1, 0, 1); }",
                "ZTest Always ZWrite Off");
            Material show =
                MaterialOf(eye + "Texture2DArray _Seen; float4 frag(v2f i) : SV_Target { return _Seen.Load(int4(i.p.xy, i.eye, 0)).gbra; }",
                "ZTest Always ZWrite Off", "Transparent");
            using var cmd = new CommandBuffer();
            for (int slice = 0; slice < 2; slice++)
                cmd.Blit(BuiltinRenderTextureType.CameraTarget, own, slice, slice);
            camera.AddCommandBuffer(CameraEvent.BeforeForwardAlpha, cmd);
            var block = new MaterialPropertyBlock();
            block.SetTexture("_Seen", own);
            Graphics.RenderPrimitives(new RenderParams(opaque) { worldBounds = everywhere }, MeshTopology.Triangles, 3);
            Graphics.RenderPrimitives(new RenderParams(show) { worldBounds = everywhere, matProps = block }, MeshTopology.Triangles, 3);
            Frame();
            Assert.That(Pixel(5, 5), Is.EqualTo(new Color32(0, 0, 255, 255)), "the left eye's red is blue now");
            Assert.That(Pixel(Width - 5, 5), Is.EqualTo(new Color32(255, 0, 0, 255)), "the right eye's green is red now");
            Object.DestroyImmediate(own);
        }

        [Test]
        public void A_slice_that_is_not_there_is_named()
        {
            RenderTexture source = Target(GraphicsFormat.R8G8B8A8_UNorm, slices: 2), own = Target(GraphicsFormat.R8G8B8A8_UNorm);
            using var cmd = new CommandBuffer();
            cmd.Blit(source, own, 1, 1);
            Assert.That(() => Graphics.ExecuteCommandBuffer(cmd),
                Throws.TypeOf<GpuUsageException>().With.Message.Contains("into slice 1 of '', which has 1"));
            Object.DestroyImmediate(source);
            Object.DestroyImmediate(own);
        }
    }
}
