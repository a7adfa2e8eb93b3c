import { readFileSync, rmSync, writeFileSync } from "node:fs";
import { gzipSync } from "fflate";
import { defineConfig } from "vite";

// The solid drawing with what it uses of three.js: one script, packed as gzip in base64, that the page unpacks when a
// reader wants it. fflate packs the same bytes on every machine, which the zlib of a node version need not.
export default defineConfig({
  build: {
    target: "es2022",
    outDir: "dist",
    emptyOutDir: false,
    lib: { entry: "src/solid/main.ts", name: "bellcrankSolidScript", formats: ["iife"], fileName: () => "solid.js" },
    rolldownOptions: {
      output: { postBanner: "/*! bellcrank report, MIT OR Apache-2.0. THIRD-PARTY: three.js (c) three.js authors, MIT licence, see THIRD-PARTY.md */" },
    },
  },
  plugins: [
    {
      name: "pack",
      closeBundle() {
        const script = readFileSync("dist/solid.js");
        writeFileSync("dist/solid.gz.txt", Buffer.from(gzipSync(script, { level: 9, mtime: 0 })).toString("base64"));
        rmSync("dist/solid.js");
        console.log(`solid.js ${script.length} bytes, packed ${readFileSync("dist/solid.gz.txt").length}`);
      },
    },
  ],
});
