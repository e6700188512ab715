/* Compiles many shaders in one process with Microsoft's d3dcompiler_47.dll, which lies beside this program; a start of wine
   for each would cost more than the shaders do.
     fxc-worker <jobs> <results>
   Integers are of 32 bits, little-endian; a text or blob is its length and then its bytes.
     jobs:     count, then a job each: name, source, entry point, profile, flags
     results:  a job each, in order, as soon as it is done: HRESULT, messages, DXBC */
#include <windows.h>
#include <d3dcompiler.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static FILE *jobs, *results;

static void fail(const char *what)
{
    fprintf(stderr, "fxc-worker: %s\n", what);
    exit(3);
}

static uint32_t read_word(void)
{
    uint32_t value;
    if (fread(&value, sizeof value, 1, jobs) != 1)
        fail("the jobs are cut off");
    return value;
}

/* With a zero behind it, for the entry point and the profile. */
static char *read_text(uint32_t *length)
{
    *length = read_word();
    char *text = malloc((size_t)*length + 1);
    if (!text)
        fail("out of memory");
    if (fread(text, 1, *length, jobs) != *length)
        fail("the jobs are cut off");
    text[*length] = 0;
    return text;
}

static void write_bytes(const void *bytes, size_t length)
{
    if (length > 0 && fwrite(bytes, 1, length, results) != length)
        fail("cannot write the results");
}

static void write_blob(ID3DBlob *blob)
{
    uint32_t length = blob ? (uint32_t)blob->lpVtbl->GetBufferSize(blob) : 0;
    write_bytes(&length, sizeof length);
    if (!blob)
        return;
    write_bytes(blob->lpVtbl->GetBufferPointer(blob), length);
    blob->lpVtbl->Release(blob);
}

int main(int count, char **arguments)
{
    HMODULE library = LoadLibraryA("d3dcompiler_47.dll");
    pD3DCompile compile = library ? (pD3DCompile)(void *)GetProcAddress(library, "D3DCompile") : NULL;
    if (!compile)
        fail("cannot load d3dcompiler_47.dll");
    jobs = count == 3 ? fopen(arguments[1], "rb") : NULL;
    results = count == 3 ? fopen(arguments[2], "wb") : NULL;
    if (!jobs || !results)
        fail("cannot open the files of jobs and results");

    for (uint32_t left = read_word(); left > 0; left--)
    {
        uint32_t length, source_length;
        char *name = read_text(&length), *source = read_text(&source_length), *entry = read_text(&length), *profile = read_text(&length);
        UINT flags = read_word();
        ID3DBlob *code = NULL, *messages = NULL;
        HRESULT outcome = compile(source, source_length, name, NULL, NULL, entry, profile, flags, 0, &code, &messages);
        int32_t word = outcome;
        write_bytes(&word, sizeof word);
        write_blob(messages);
        write_blob(code);
        if (fflush(results))
            fail("cannot write the results");
        free(name);
        free(source);
        free(entry);
        free(profile);
    }
    return 0;
}
