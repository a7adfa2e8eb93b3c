import { defineConfig } from "vite";

// Parts to turn: a script and a sheet of their own, which only pages with pictures of parts carry. What they use of
// three.js comes with the solid drawing.
export default defineConfig({
  build: {
    target: "es2022",
    outDir: "dist",
    emptyOutDir: false,
    cssCodeSplit: false,
    lib: { entry: "src/contour/main.ts", name: "bellcrankContour", formats: ["iife"], fileName: () => "contour.js", cssFileName: "contour" },
    rolldownOptions: { output: { postBanner: "/*! bellcrank report, MIT OR Apache-2.0 */" } },
  },
});
