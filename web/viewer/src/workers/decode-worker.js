// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Decodes for the plugin of GLTFLoader.
import '@deltamesh/decoder/worker.js';
